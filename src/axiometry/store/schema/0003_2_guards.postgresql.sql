-- SPDX-License-Identifier: Apache-2.0
-- As 0001_3_guards.

CREATE TRIGGER calibration_version_unchanged BEFORE UPDATE OR DELETE ON calibration_version FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER calibration_version_untruncated BEFORE TRUNCATE ON calibration_version EXECUTE FUNCTION refuse_change();
CREATE TRIGGER calibration_unchanged BEFORE UPDATE OF id OR DELETE ON calibration
  FOR EACH ROW EXECUTE FUNCTION refuse_change();
CREATE TRIGGER calibration_grows BEFORE UPDATE OF latest ON calibration FOR EACH ROW EXECUTE FUNCTION refuse_gap();
CREATE TRIGGER calibration_untruncated BEFORE TRUNCATE ON calibration EXECUTE FUNCTION refuse_change();
