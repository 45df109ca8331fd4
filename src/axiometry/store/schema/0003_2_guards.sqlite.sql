-- SPDX-License-Identifier: Apache-2.0
-- As 0001_3_guards.

CREATE TRIGGER calibration_version_unchanged BEFORE UPDATE ON calibration_version BEGIN
  SELECT RAISE(ABORT, 'found an update of calibration_version, whose rows are never changed');
END;
CREATE TRIGGER calibration_version_undeleted BEFORE DELETE ON calibration_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from calibration_version, whose rows are never taken away');
END;
CREATE TRIGGER calibration_version_unreplaced BEFORE INSERT ON calibration_version WHEN EXISTS (SELECT 1 FROM calibration_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for calibration_version that is there already');
END;

CREATE TRIGGER calibration_unchanged BEFORE UPDATE OF id ON calibration BEGIN
  SELECT RAISE(ABORT, 'found an update of calibration, whose rows are never changed');
END;
CREATE TRIGGER calibration_grows BEFORE UPDATE OF latest ON calibration WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of calibration that does not follow the latest one');
END;
CREATE TRIGGER calibration_undeleted BEFORE DELETE ON calibration BEGIN
  SELECT RAISE(ABORT, 'found a deletion from calibration, whose rows are never taken away');
END;
CREATE TRIGGER calibration_unreplaced BEFORE INSERT ON calibration WHEN EXISTS (SELECT 1 FROM calibration WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for calibration that is there already');
END;
