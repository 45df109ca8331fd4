#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""LinuxCNC's own motion controller in simulation: one joint that is driven to targets, its motor read through HAL.

As a library: `drive(folder, stops, comp)` starts the controller in a folder, with a COMP_FILE of its joint or none, goes
to each stop and gives the position of the motor at rest there: what the commands make of the motor, compensation and
all. The same file is the controller's user interface, which LinuxCNC starts itself (Debian package linuxcnc-uspace).
"""
import json
import os
import pathlib
import subprocess
import sys
import time

INI = """[EMC]
VERSION = 1.1
MACHINE = one joint
[DISPLAY]
DISPLAY = {interface}
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = joint.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 4.0
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.100
TOOL_TABLE = joint.tbl
[HAL]
HALFILE = joint.hal
[KINS]
KINEMATICS = trivkins coordinates=X
JOINTS = 1
[TRAJ]
COORDINATES = X
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = 500
MAX_LINEAR_VELOCITY = 1000
NO_FORCE_HOMING = 1
[AXIS_X]
MIN_LIMIT = -1000
MAX_LIMIT = 1000
MAX_VELOCITY = 1000
MAX_ACCELERATION = 10000
[JOINT_0]
TYPE = LINEAR
HOME = 0
MIN_LIMIT = -1000
MAX_LIMIT = 1000
MAX_VELOCITY = 1000
MAX_ACCELERATION = 10000
FERROR = 100
MIN_FERROR = 100
HOME_SEARCH_VEL = 0
HOME_LATCH_VEL = 0
HOME_SEQUENCE = 0
{comp}
"""
HAL = """loadrt trivkins coordinates=X
loadrt motmod servo_period_nsec=1000000 num_joints=1
addf motion-command-handler servo-thread
addf motion-controller servo-thread
net motor joint.0.motor-pos-cmd => joint.0.motor-pos-fb
net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net change iocontrol.0.tool-change => iocontrol.0.tool-changed
"""


def environment(folder):
    """A controller of its own, beside any other of this machine; as root it wants a user to fall back to."""
    own = {"HOME": str(folder), "RTAPI_FIFO_PATH": str(folder / "rtapi"), "PYTHONDONTWRITEBYTECODE": "1"}
    if os.getuid() == 0:
        own["RTAPI_UID"] = "65534"
        folder.chmod(0o777)
    return dict(os.environ, **own)


def drive(folder, stops, comp=None, comp_type=0, seconds=120):
    """Motor positions, mm, at rest at each stop in turn."""
    folder = pathlib.Path(folder)
    extra = f"COMP_FILE = {comp}\nCOMP_FILE_TYPE = {comp_type}\n" if comp else ""
    (folder / "joint.ini").write_text(INI.format(interface=pathlib.Path(__file__).resolve(), comp=extra))
    (folder / "joint.hal").write_text(HAL)
    (folder / "joint.tbl").write_text("")
    (folder / "stops.json").write_text(json.dumps(stops))
    (folder / "positions.json").unlink(missing_ok=True)
    done = subprocess.run(["linuxcnc", "-r", "joint.ini"], cwd=folder, timeout=seconds, capture_output=True, text=True,
                          env=environment(folder))
    found = folder / "positions.json"
    if not found.exists():
        raise RuntimeError(f"LinuxCNC ended with {done.returncode}:\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return json.loads(found.read_text())


# ---------------------------------------------------------------- the user interface, in a process of LinuxCNC's

def at_rest(motor, near, seconds=20.0):
    """The motor's position near a stop, once it has been the same for a while."""
    last, since, end = None, time.monotonic(), time.monotonic() + seconds
    while time.monotonic() < end:
        now = motor()
        if now != last or abs(now - near) > 1.0:
            last, since = now, time.monotonic()
        elif time.monotonic() - since > 0.05:
            return now
        time.sleep(0.002)
    raise RuntimeError(f"the joint does not come to rest at {near}")


def user_interface():
    import hal
    import linuxcnc
    reader = hal.component("reader")  # values are given as long as it lives
    reader.ready()
    command, status = linuxcnc.command(), linuxcnc.stat()

    def wait_for(what, seconds=20.0):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            status.poll()
            if what():
                return
            time.sleep(0.01)
        raise RuntimeError("LinuxCNC does not answer")

    command.state(linuxcnc.STATE_ESTOP_RESET)
    wait_for(lambda: status.task_state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_OFF, linuxcnc.STATE_ON))
    command.state(linuxcnc.STATE_ON)
    wait_for(lambda: status.task_state == linuxcnc.STATE_ON)
    command.teleop_enable(0)
    command.wait_complete()
    command.home(0)
    wait_for(lambda: status.homed[0] == 1)
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    positions = []
    for stop in json.loads(pathlib.Path("stops.json").read_text()):
        command.mdi(f"G53 G0 X{stop:.6f}")
        command.wait_complete(20.0)
        positions.append(at_rest(lambda: hal.get_value("joint.0.motor-pos-cmd"), stop))
    pathlib.Path("positions.json").write_text(json.dumps(positions))


if __name__ == "__main__":
    user_interface()
    sys.exit(0)
