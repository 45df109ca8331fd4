-- SPDX-License-Identifier: Apache-2.0
-- Tables by which a control corrects an axis: made from a version of a test, perhaps proved by another test that was
-- measured with the table active. The table itself, the one that was active before and the result are contents; `files`,
-- `options` and `figures` are JSON. Withdrawal is a version.
CREATE TABLE compensation (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE compensation_version (
  id integer NOT NULL REFERENCES compensation (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  test integer NOT NULL,
  test_version integer NOT NULL,
  retest integer,
  retest_version integer,
  axis integer REFERENCES axis (id),
  control plain_text NOT NULL,
  notes plain_text NOT NULL,
  withdrawn integer NOT NULL,
  files plain_text NOT NULL,
  program plain_text NOT NULL,
  options plain_text NOT NULL,
  result plain_text NOT NULL REFERENCES content (sha256),
  serious integer NOT NULL,
  figures plain_text NOT NULL,
  PRIMARY KEY (id, version),
  FOREIGN KEY (test, test_version) REFERENCES test_version (test, version),
  FOREIGN KEY (retest, retest_version) REFERENCES test_version (test, version)
);
CREATE INDEX compensation_of_test ON compensation_version (test);
CREATE INDEX compensation_of_retest ON compensation_version (retest);
CREATE INDEX compensation_of_axis ON compensation_version (axis);
