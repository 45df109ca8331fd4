-- SPDX-License-Identifier: Apache-2.0
-- As 0001_3_guards.

CREATE TRIGGER compensation_version_unchanged BEFORE UPDATE ON compensation_version BEGIN
  SELECT RAISE(ABORT, 'found an update of compensation_version, whose rows are never changed');
END;
CREATE TRIGGER compensation_version_undeleted BEFORE DELETE ON compensation_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from compensation_version, whose rows are never taken away');
END;
CREATE TRIGGER compensation_version_unreplaced BEFORE INSERT ON compensation_version WHEN EXISTS (SELECT 1 FROM compensation_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for compensation_version that is there already');
END;

CREATE TRIGGER compensation_unchanged BEFORE UPDATE OF id ON compensation BEGIN
  SELECT RAISE(ABORT, 'found an update of compensation, whose rows are never changed');
END;
CREATE TRIGGER compensation_grows BEFORE UPDATE OF latest ON compensation WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of compensation that does not follow the latest one');
END;
CREATE TRIGGER compensation_undeleted BEFORE DELETE ON compensation BEGIN
  SELECT RAISE(ABORT, 'found a deletion from compensation, whose rows are never taken away');
END;
CREATE TRIGGER compensation_unreplaced BEFORE INSERT ON compensation WHEN EXISTS (SELECT 1 FROM compensation WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for compensation that is there already');
END;
