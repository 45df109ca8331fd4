-- SPDX-License-Identifier: Apache-2.0
-- What was written stays: not even a program that knows nothing of this one changes it. INSERT OR REPLACE would delete
-- without asking the triggers of DELETE, so a key that exists is refused too.

CREATE TRIGGER content_unchanged BEFORE UPDATE ON content BEGIN
  SELECT RAISE(ABORT, 'found an update of content, whose rows are never changed');
END;
CREATE TRIGGER content_undeleted BEFORE DELETE ON content BEGIN
  SELECT RAISE(ABORT, 'found a deletion from content, whose rows are never taken away');
END;
CREATE TRIGGER content_unreplaced BEFORE INSERT ON content WHEN EXISTS (SELECT 1 FROM content WHERE id = NEW.id OR sha256 = NEW.sha256) BEGIN
  SELECT RAISE(ABORT, 'found a row for content that is there already');
END;

CREATE TRIGGER machine_version_unchanged BEFORE UPDATE ON machine_version BEGIN
  SELECT RAISE(ABORT, 'found an update of machine_version, whose rows are never changed');
END;
CREATE TRIGGER machine_version_undeleted BEFORE DELETE ON machine_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from machine_version, whose rows are never taken away');
END;
CREATE TRIGGER machine_version_unreplaced BEFORE INSERT ON machine_version WHEN EXISTS (SELECT 1 FROM machine_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for machine_version that is there already');
END;

CREATE TRIGGER axis_version_unchanged BEFORE UPDATE ON axis_version BEGIN
  SELECT RAISE(ABORT, 'found an update of axis_version, whose rows are never changed');
END;
CREATE TRIGGER axis_version_undeleted BEFORE DELETE ON axis_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from axis_version, whose rows are never taken away');
END;
CREATE TRIGGER axis_version_unreplaced BEFORE INSERT ON axis_version WHEN EXISTS (SELECT 1 FROM axis_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for axis_version that is there already');
END;

CREATE TRIGGER instrument_version_unchanged BEFORE UPDATE ON instrument_version BEGIN
  SELECT RAISE(ABORT, 'found an update of instrument_version, whose rows are never changed');
END;
CREATE TRIGGER instrument_version_undeleted BEFORE DELETE ON instrument_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from instrument_version, whose rows are never taken away');
END;
CREATE TRIGGER instrument_version_unreplaced BEFORE INSERT ON instrument_version WHEN EXISTS (SELECT 1 FROM instrument_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for instrument_version that is there already');
END;

CREATE TRIGGER plan_version_unchanged BEFORE UPDATE ON plan_version BEGIN
  SELECT RAISE(ABORT, 'found an update of plan_version, whose rows are never changed');
END;
CREATE TRIGGER plan_version_undeleted BEFORE DELETE ON plan_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from plan_version, whose rows are never taken away');
END;
CREATE TRIGGER plan_version_unreplaced BEFORE INSERT ON plan_version WHEN EXISTS (SELECT 1 FROM plan_version WHERE id = NEW.id AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for plan_version that is there already');
END;

CREATE TRIGGER test_version_unchanged BEFORE UPDATE ON test_version BEGIN
  SELECT RAISE(ABORT, 'found an update of test_version, whose rows are never changed');
END;
CREATE TRIGGER test_version_undeleted BEFORE DELETE ON test_version BEGIN
  SELECT RAISE(ABORT, 'found a deletion from test_version, whose rows are never taken away');
END;
CREATE TRIGGER test_version_unreplaced BEFORE INSERT ON test_version WHEN EXISTS (SELECT 1 FROM test_version WHERE test = NEW.test AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for test_version that is there already');
END;

CREATE TRIGGER test_instrument_unchanged BEFORE UPDATE ON test_instrument BEGIN
  SELECT RAISE(ABORT, 'found an update of test_instrument, whose rows are never changed');
END;
CREATE TRIGGER test_instrument_undeleted BEFORE DELETE ON test_instrument BEGIN
  SELECT RAISE(ABORT, 'found a deletion from test_instrument, whose rows are never taken away');
END;
CREATE TRIGGER test_instrument_unreplaced BEFORE INSERT ON test_instrument WHEN EXISTS (SELECT 1 FROM test_instrument WHERE test = NEW.test AND version = NEW.version AND place = NEW.place) BEGIN
  SELECT RAISE(ABORT, 'found a row for test_instrument that is there already');
END;

CREATE TRIGGER evaluation_unchanged BEFORE UPDATE ON evaluation BEGIN
  SELECT RAISE(ABORT, 'found an update of evaluation, whose rows are never changed');
END;
CREATE TRIGGER evaluation_undeleted BEFORE DELETE ON evaluation BEGIN
  SELECT RAISE(ABORT, 'found a deletion from evaluation, whose rows are never taken away');
END;
CREATE TRIGGER evaluation_unreplaced BEFORE INSERT ON evaluation WHEN EXISTS (SELECT 1 FROM evaluation WHERE test = NEW.test AND version = NEW.version) BEGIN
  SELECT RAISE(ABORT, 'found a row for evaluation that is there already');
END;

CREATE TRIGGER figure_unchanged BEFORE UPDATE ON figure BEGIN
  SELECT RAISE(ABORT, 'found an update of figure, whose rows are never changed');
END;
CREATE TRIGGER figure_undeleted BEFORE DELETE ON figure BEGIN
  SELECT RAISE(ABORT, 'found a deletion from figure, whose rows are never taken away');
END;
CREATE TRIGGER figure_unreplaced BEFORE INSERT ON figure WHEN EXISTS (SELECT 1 FROM figure WHERE test = NEW.test AND version = NEW.version AND place = NEW.place) BEGIN
  SELECT RAISE(ABORT, 'found a row for figure that is there already');
END;

CREATE TRIGGER document_unchanged BEFORE UPDATE ON document BEGIN
  SELECT RAISE(ABORT, 'found an update of document, whose rows are never changed');
END;
CREATE TRIGGER document_undeleted BEFORE DELETE ON document BEGIN
  SELECT RAISE(ABORT, 'found a deletion from document, whose rows are never taken away');
END;
CREATE TRIGGER document_unreplaced BEFORE INSERT ON document WHEN EXISTS (SELECT 1 FROM document WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for document that is there already');
END;

CREATE TRIGGER audit_unchanged BEFORE UPDATE ON audit BEGIN
  SELECT RAISE(ABORT, 'found an update of audit, whose rows are never changed');
END;
CREATE TRIGGER audit_undeleted BEFORE DELETE ON audit BEGIN
  SELECT RAISE(ABORT, 'found a deletion from audit, whose rows are never taken away');
END;
CREATE TRIGGER audit_unreplaced BEFORE INSERT ON audit WHEN EXISTS (SELECT 1 FROM audit WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for audit that is there already');
END;

CREATE TRIGGER migration_unchanged BEFORE UPDATE ON migration BEGIN
  SELECT RAISE(ABORT, 'found an update of migration, whose rows are never changed');
END;
CREATE TRIGGER migration_undeleted BEFORE DELETE ON migration BEGIN
  SELECT RAISE(ABORT, 'found a deletion from migration, whose rows are never taken away');
END;
CREATE TRIGGER migration_unreplaced BEFORE INSERT ON migration WHEN EXISTS (SELECT 1 FROM migration WHERE number = NEW.number) BEGIN
  SELECT RAISE(ABORT, 'found a row for migration that is there already');
END;

CREATE TRIGGER machine_unchanged BEFORE UPDATE OF id ON machine BEGIN
  SELECT RAISE(ABORT, 'found an update of machine, whose rows are never changed');
END;
CREATE TRIGGER machine_grows BEFORE UPDATE OF latest ON machine WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of machine that does not follow the latest one');
END;
CREATE TRIGGER machine_undeleted BEFORE DELETE ON machine BEGIN
  SELECT RAISE(ABORT, 'found a deletion from machine, whose rows are never taken away');
END;
CREATE TRIGGER machine_unreplaced BEFORE INSERT ON machine WHEN EXISTS (SELECT 1 FROM machine WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for machine that is there already');
END;

CREATE TRIGGER axis_unchanged BEFORE UPDATE OF id ON axis BEGIN
  SELECT RAISE(ABORT, 'found an update of axis, whose rows are never changed');
END;
CREATE TRIGGER axis_grows BEFORE UPDATE OF latest ON axis WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of axis that does not follow the latest one');
END;
CREATE TRIGGER axis_undeleted BEFORE DELETE ON axis BEGIN
  SELECT RAISE(ABORT, 'found a deletion from axis, whose rows are never taken away');
END;
CREATE TRIGGER axis_unreplaced BEFORE INSERT ON axis WHEN EXISTS (SELECT 1 FROM axis WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for axis that is there already');
END;

CREATE TRIGGER instrument_unchanged BEFORE UPDATE OF id ON instrument BEGIN
  SELECT RAISE(ABORT, 'found an update of instrument, whose rows are never changed');
END;
CREATE TRIGGER instrument_grows BEFORE UPDATE OF latest ON instrument WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of instrument that does not follow the latest one');
END;
CREATE TRIGGER instrument_undeleted BEFORE DELETE ON instrument BEGIN
  SELECT RAISE(ABORT, 'found a deletion from instrument, whose rows are never taken away');
END;
CREATE TRIGGER instrument_unreplaced BEFORE INSERT ON instrument WHEN EXISTS (SELECT 1 FROM instrument WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for instrument that is there already');
END;

CREATE TRIGGER plan_unchanged BEFORE UPDATE OF id ON plan BEGIN
  SELECT RAISE(ABORT, 'found an update of plan, whose rows are never changed');
END;
CREATE TRIGGER plan_grows BEFORE UPDATE OF latest ON plan WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of plan that does not follow the latest one');
END;
CREATE TRIGGER plan_undeleted BEFORE DELETE ON plan BEGIN
  SELECT RAISE(ABORT, 'found a deletion from plan, whose rows are never taken away');
END;
CREATE TRIGGER plan_unreplaced BEFORE INSERT ON plan WHEN EXISTS (SELECT 1 FROM plan WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for plan that is there already');
END;

CREATE TRIGGER test_unchanged BEFORE UPDATE OF id, content, file_name, format, name_in_file, at, actor, reason ON test BEGIN
  SELECT RAISE(ABORT, 'found an update of test, whose rows are never changed');
END;
CREATE TRIGGER test_grows BEFORE UPDATE OF latest ON test WHEN NEW.latest <> OLD.latest + 1 BEGIN
  SELECT RAISE(ABORT, 'found a version of test that does not follow the latest one');
END;
CREATE TRIGGER test_undeleted BEFORE DELETE ON test BEGIN
  SELECT RAISE(ABORT, 'found a deletion from test, whose rows are never taken away');
END;
CREATE TRIGGER test_unreplaced BEFORE INSERT ON test WHEN EXISTS (SELECT 1 FROM test WHERE id = NEW.id) BEGIN
  SELECT RAISE(ABORT, 'found a row for test that is there already');
END;

-- NULL last in either direction: SQLite reads these indexes from both ends.
CREATE INDEX list_by_a ON test_list (value_a, test, withdrawn);
CREATE INDEX list_by_e ON test_list (value_e, test, withdrawn);
CREATE INDEX list_by_r ON test_list (value_r, test, withdrawn);
CREATE INDEX list_by_b ON test_list (value_b, test, withdrawn);
