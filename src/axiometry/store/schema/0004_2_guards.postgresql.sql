-- SPDX-License-Identifier: Apache-2.0
-- As 0001_3_guards.

CREATE TRIGGER compensation_version_unchanged BEFORE UPDATE OR DELETE ON compensation_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER compensation_version_untruncated BEFORE TRUNCATE ON compensation_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER compensation_unchanged BEFORE UPDATE OF id OR DELETE ON compensation
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER compensation_grows BEFORE UPDATE OF latest ON compensation FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER compensation_untruncated BEFORE TRUNCATE ON compensation EXECUTE FUNCTION refuse_change();
