-- SPDX-License-Identifier: Apache-2.0
-- The archive. Rows of the first part are only ever added; the guards (0001_3_guards) see to it. Ids count from 1
-- without gaps. Times are RFC 3339 in UTC. sha256 of a version is that of all its fields (store/fingerprint.h).

CREATE TABLE content (
  id integer PRIMARY KEY,
  sha256 plain_text NOT NULL UNIQUE,
  file_name plain_text NOT NULL,
  format plain_text NOT NULL,
  size bigint NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  bytes blob NOT NULL
);
CREATE INDEX content_size ON content (size);

-- A thing and its versions: `latest` grows by one with each, nothing else of them changes.
CREATE TABLE machine (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE machine_version (
  id integer NOT NULL REFERENCES machine (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  name plain_text NOT NULL,
  manufacturer plain_text NOT NULL,
  type plain_text NOT NULL,
  serial_number plain_text NOT NULL,
  controller plain_text NOT NULL,
  location plain_text NOT NULL,
  notes plain_text NOT NULL,
  PRIMARY KEY (id, version)
);

CREATE TABLE axis (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE axis_version (
  id integer NOT NULL REFERENCES axis (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  machine integer NOT NULL REFERENCES machine (id),
  name plain_text NOT NULL,
  kind plain_text NOT NULL,
  limits plain_text NOT NULL,
  notes plain_text NOT NULL,
  PRIMARY KEY (id, version)
);
CREATE INDEX axis_of_machine ON axis_version (machine);

CREATE TABLE instrument (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE instrument_version (
  id integer NOT NULL REFERENCES instrument (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  role plain_text NOT NULL,
  manufacturer plain_text NOT NULL,
  type plain_text NOT NULL,
  serial_number plain_text NOT NULL,
  certificate plain_text NOT NULL,
  calibrated_on plain_text NOT NULL,
  calibration_due plain_text NOT NULL,
  inputs plain_text NOT NULL,
  notes plain_text NOT NULL,
  PRIMARY KEY (id, version)
);

CREATE TABLE plan (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE plan_version (
  id integer NOT NULL REFERENCES plan (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  title plain_text NOT NULL,
  axis integer REFERENCES axis (id),
  content plain_text NOT NULL REFERENCES content (sha256),
  PRIMARY KEY (id, version)
);

-- A test is a file's measured bytes; what may be edited stands in its versions. Only `latest` and `withdrawn` change.
CREATE TABLE test (
  id integer PRIMARY KEY,
  content plain_text NOT NULL REFERENCES content (sha256),
  file_name plain_text NOT NULL,
  format plain_text NOT NULL,
  name_in_file plain_text NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  latest integer NOT NULL,
  withdrawn integer NOT NULL
);

CREATE TABLE test_version (
  test integer NOT NULL REFERENCES test (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  title plain_text NOT NULL,
  machine integer REFERENCES machine (id),
  axis integer REFERENCES axis (id),
  axis_name plain_text NOT NULL,
  axis_kind plain_text NOT NULL,
  plan integer REFERENCES plan (id),
  measured_on plain_text NOT NULL,
  changes plain_text NOT NULL,
  PRIMARY KEY (test, version)
);

CREATE TABLE test_instrument (
  test integer NOT NULL,
  version integer NOT NULL,
  place integer NOT NULL,
  instrument integer NOT NULL,
  instrument_version integer NOT NULL,
  PRIMARY KEY (test, version, place),
  FOREIGN KEY (test, version) REFERENCES test_version (test, version),
  FOREIGN KEY (instrument, instrument_version) REFERENCES instrument_version (id, version)
);

CREATE TABLE evaluation (
  test integer NOT NULL,
  version integer NOT NULL,
  program plain_text NOT NULL,
  standard plain_text NOT NULL,
  options plain_text NOT NULL,
  seed plain_text,
  unit plain_text NOT NULL,
  conforming integer NOT NULL,
  verdict plain_text NOT NULL,
  label plain_text NOT NULL,
  result plain_text NOT NULL,
  PRIMARY KEY (test, version),
  FOREIGN KEY (test, version) REFERENCES test_version (test, version)
);

CREATE TABLE figure (
  test integer NOT NULL,
  version integer NOT NULL,
  place integer NOT NULL,
  parameter plain_text NOT NULL,
  value double precision NOT NULL,
  expanded_uncertainty double precision,
  tolerance double precision,
  verdict plain_text NOT NULL,
  PRIMARY KEY (test, version, place),
  FOREIGN KEY (test, version) REFERENCES test_version (test, version)
);

CREATE TABLE document (
  id integer PRIMARY KEY,
  test integer NOT NULL,
  version integer NOT NULL,
  kind plain_text NOT NULL,
  name plain_text NOT NULL,
  media_type plain_text NOT NULL,
  language plain_text NOT NULL,
  content plain_text NOT NULL REFERENCES content (sha256),
  size bigint NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  FOREIGN KEY (test, version) REFERENCES test_version (test, version)
);
CREATE INDEX document_of_test ON document (test);

CREATE TABLE audit (
  id integer PRIMARY KEY,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  action plain_text NOT NULL,
  subject plain_text NOT NULL,
  detail plain_text NOT NULL,
  sha256 plain_text NOT NULL
);
CREATE INDEX audit_subject ON audit (subject, id);
CREATE INDEX audit_action ON audit (action);

-- Lists: the latest version of each test in one narrow row, so that no JSON is read for them. Follows from the tables
-- above, is kept in step by the program and checked by verify(). Each order has an index that alone answers for it.
CREATE TABLE test_list (
  test integer PRIMARY KEY REFERENCES test (id),
  version integer NOT NULL,
  withdrawn integer NOT NULL,
  conforming integer NOT NULL,
  machine integer,
  axis integer,
  value_a double precision,
  value_e double precision,
  value_r double precision,
  value_b double precision,
  unit plain_text NOT NULL,
  verdict plain_text NOT NULL,
  measured_on plain_text NOT NULL,
  received_at plain_text NOT NULL,
  title_key plain_text NOT NULL,
  file_key plain_text NOT NULL,
  machine_key plain_text NOT NULL,
  axis_key plain_text NOT NULL,
  title plain_text NOT NULL,
  file_name plain_text NOT NULL,
  machine_name plain_text NOT NULL,
  axis_name plain_text NOT NULL,
  axis_kind plain_text NOT NULL,
  label plain_text NOT NULL,
  content plain_text NOT NULL
);
CREATE INDEX list_withdrawn ON test_list (withdrawn, test);
CREATE INDEX list_machine ON test_list (machine, withdrawn, measured_on, test);
CREATE INDEX list_axis ON test_list (axis, withdrawn, measured_on, test);
CREATE INDEX list_verdict ON test_list (verdict, withdrawn, test);
CREATE INDEX list_content ON test_list (content);
CREATE INDEX list_by_measured ON test_list (measured_on, test, withdrawn);
CREATE INDEX list_by_title ON test_list (title_key, test, withdrawn);
CREATE INDEX list_by_machine ON test_list (machine_key, axis_key, test, withdrawn);

-- The folded words that a text is looked for in, apart from the rest: all of them are read for each search.
CREATE TABLE test_search (
  test integer PRIMARY KEY REFERENCES test (id),
  withdrawn integer NOT NULL,
  words plain_text NOT NULL
);

CREATE TABLE list_instrument (
  instrument integer NOT NULL REFERENCES instrument (id),
  withdrawn integer NOT NULL,
  test integer NOT NULL REFERENCES test (id),
  PRIMARY KEY (instrument, withdrawn, test)
);
CREATE INDEX list_instrument_test ON list_instrument (test);
