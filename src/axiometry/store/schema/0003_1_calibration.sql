-- SPDX-License-Identifier: Apache-2.0
-- What a tracking interferometer found of a machine as a whole: the lines of a plan, or the 21 errors. The files it was
-- evaluated from and the result are contents; `files`, `options` and `figures` are JSON. Withdrawal is a version.
CREATE TABLE calibration (id integer PRIMARY KEY, latest integer NOT NULL);
CREATE TABLE calibration_version (
  id integer NOT NULL REFERENCES calibration (id),
  version integer NOT NULL,
  at plain_text NOT NULL,
  actor plain_text NOT NULL,
  reason plain_text NOT NULL,
  sha256 plain_text NOT NULL,
  kind plain_text NOT NULL,
  title plain_text NOT NULL,
  machine integer REFERENCES machine (id),
  instrument integer,
  instrument_version integer,
  measured_on plain_text NOT NULL,
  notes plain_text NOT NULL,
  withdrawn integer NOT NULL,
  files plain_text NOT NULL,
  program plain_text NOT NULL,
  options plain_text NOT NULL,
  result plain_text NOT NULL REFERENCES content (sha256),
  verdict plain_text NOT NULL,
  serious integer NOT NULL,
  figures plain_text NOT NULL,
  PRIMARY KEY (id, version),
  FOREIGN KEY (instrument, instrument_version) REFERENCES instrument_version (id, version)
);
CREATE INDEX calibration_of_machine ON calibration_version (machine);
