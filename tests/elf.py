# SPDX-License-Identifier: Apache-2.0
"""What the headers of a program say (ELF). No third-party modules."""
import struct
import sys

PT_LOAD, PT_DYNAMIC = 1, 2
PF_X, PF_W = 1, 2
DT_NULL, DT_NEEDED, DT_STRTAB, DT_STRSZ = 0, 1, 5, 10


class Elf:
    """64 bits, the byte order of the file."""

    def __init__(self, data):
        if data[:4] != b"\x7fELF" or data[4] != 2:
            sys.exit("found no ELF file of 64 bits")
        self.data = data
        self.order = "<" if data[5] == 1 else ">"
        self.type, self.machine = self.unpack("HH", 16)
        offset, size, count = self.unpack("Q", 32)[0], *self.unpack("HH", 54)
        self.segments = [dict(zip(("type", "flags", "offset", "address", "physical", "file_size", "memory"),
                                  self.unpack("IIQQQQQ", offset + k * size))) for k in range(count)]

    def unpack(self, fields, at):
        return struct.unpack_from(self.order + fields, self.data, at)

    def of_type(self, kind):
        return [s for s in self.segments if s["type"] == kind]

    def dynamic_list(self):
        segment = self.of_type(PT_DYNAMIC)[0]
        for at in range(segment["offset"], segment["offset"] + segment["file_size"], 16):
            tag, value = self.unpack("qQ", at)
            if tag == DT_NULL:
                return
            yield tag, value

    def dynamic(self):
        return dict(self.dynamic_list())

    def offset_of(self, address):
        return next(address - s["address"] + s["offset"] for s in self.of_type(PT_LOAD)
                    if s["address"] <= address < s["address"] + s["file_size"])

    def names(self):
        """All that is looked up in other files, or by them: functions, variables, libraries, versions."""
        dynamic = self.dynamic()
        at = self.offset_of(dynamic[DT_STRTAB])
        return set(self.data[at:at + dynamic[DT_STRSZ]].decode().split("\0"))

    def code(self):
        """The bytes that can be executed."""
        return b"".join(self.data[s["offset"]:s["offset"] + s["file_size"]]
                        for s in self.of_type(PT_LOAD) if s["flags"] & PF_X)

    def libraries(self):
        """Names of the shared libraries that it asks for itself."""
        at = self.offset_of(self.dynamic()[DT_STRTAB])
        return {self.data[at + value:self.data.index(b"\0", at + value)].decode()
                for tag, value in self.dynamic_list() if tag == DT_NEEDED}
