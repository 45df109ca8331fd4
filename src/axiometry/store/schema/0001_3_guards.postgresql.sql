-- SPDX-License-Identifier: Apache-2.0
-- What was written stays: not even a program that knows nothing of this one changes it.

CREATE FUNCTION refuse_change() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  RAISE EXCEPTION 'found % of %, whose rows are never changed or taken away', lower(TG_OP), TG_TABLE_NAME;
END $$;

CREATE FUNCTION refuse_gap() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  IF NEW.latest NOT IN (OLD.latest, OLD.latest + 1) THEN
    RAISE EXCEPTION 'found a version of % that does not follow the latest one', TG_TABLE_NAME;
  END IF;
  RETURN NEW;
END $$;

CREATE TRIGGER content_unchanged BEFORE UPDATE OR DELETE ON content FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER content_untruncated BEFORE TRUNCATE ON content EXECUTE FUNCTION refuse_change();
CREATE TRIGGER machine_version_unchanged BEFORE UPDATE OR DELETE ON machine_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER machine_version_untruncated BEFORE TRUNCATE ON machine_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER axis_version_unchanged BEFORE UPDATE OR DELETE ON axis_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER axis_version_untruncated BEFORE TRUNCATE ON axis_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER instrument_version_unchanged BEFORE UPDATE OR DELETE ON instrument_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER instrument_version_untruncated BEFORE TRUNCATE ON instrument_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER plan_version_unchanged BEFORE UPDATE OR DELETE ON plan_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER plan_version_untruncated BEFORE TRUNCATE ON plan_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_version_unchanged BEFORE UPDATE OR DELETE ON test_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_version_untruncated BEFORE TRUNCATE ON test_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_instrument_unchanged BEFORE UPDATE OR DELETE ON test_instrument FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_instrument_untruncated BEFORE TRUNCATE ON test_instrument EXECUTE FUNCTION refuse_change();
CREATE TRIGGER evaluation_unchanged BEFORE UPDATE OR DELETE ON evaluation FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER evaluation_untruncated BEFORE TRUNCATE ON evaluation EXECUTE FUNCTION refuse_change();
CREATE TRIGGER figure_unchanged BEFORE UPDATE OR DELETE ON figure FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER figure_untruncated BEFORE TRUNCATE ON figure EXECUTE FUNCTION refuse_change();
CREATE TRIGGER document_unchanged BEFORE UPDATE OR DELETE ON document FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER document_untruncated BEFORE TRUNCATE ON document EXECUTE FUNCTION refuse_change();
CREATE TRIGGER audit_unchanged BEFORE UPDATE OR DELETE ON audit FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER audit_untruncated BEFORE TRUNCATE ON audit EXECUTE FUNCTION refuse_change();
CREATE TRIGGER migration_unchanged BEFORE UPDATE OR DELETE ON migration FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER migration_untruncated BEFORE TRUNCATE ON migration EXECUTE FUNCTION refuse_change();
CREATE TRIGGER machine_unchanged BEFORE UPDATE OF id OR DELETE ON machine
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER machine_grows BEFORE UPDATE OF latest ON machine FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER machine_untruncated BEFORE TRUNCATE ON machine EXECUTE FUNCTION refuse_change();
CREATE TRIGGER axis_unchanged BEFORE UPDATE OF id OR DELETE ON axis
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER axis_grows BEFORE UPDATE OF latest ON axis FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER axis_untruncated BEFORE TRUNCATE ON axis EXECUTE FUNCTION refuse_change();
CREATE TRIGGER instrument_unchanged BEFORE UPDATE OF id OR DELETE ON instrument
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER instrument_grows BEFORE UPDATE OF latest ON instrument FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER instrument_untruncated BEFORE TRUNCATE ON instrument EXECUTE FUNCTION refuse_change();
CREATE TRIGGER plan_unchanged BEFORE UPDATE OF id OR DELETE ON plan
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER plan_grows BEFORE UPDATE OF latest ON plan FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER plan_untruncated BEFORE TRUNCATE ON plan EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_unchanged BEFORE UPDATE OF id, content, file_name, format, name_in_file, at, actor, reason OR DELETE ON test
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER test_grows BEFORE UPDATE OF latest ON test FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER test_untruncated BEFORE TRUNCATE ON test EXECUTE FUNCTION refuse_change();

-- NULL last in either direction.
CREATE INDEX list_by_a ON test_list (value_a DESC NULLS LAST, test DESC, withdrawn);
CREATE INDEX list_by_a_up ON test_list (value_a NULLS LAST, test, withdrawn);
CREATE INDEX list_by_e ON test_list (value_e DESC NULLS LAST, test DESC, withdrawn);
CREATE INDEX list_by_e_up ON test_list (value_e NULLS LAST, test, withdrawn);
CREATE INDEX list_by_r ON test_list (value_r DESC NULLS LAST, test DESC, withdrawn);
CREATE INDEX list_by_r_up ON test_list (value_r NULLS LAST, test, withdrawn);
CREATE INDEX list_by_b ON test_list (value_b DESC NULLS LAST, test DESC, withdrawn);
CREATE INDEX list_by_b_up ON test_list (value_b NULLS LAST, test, withdrawn);
