#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads every message of a DataFlash log in plain Python, for bench/import_bench.

  read_dataflash.py FILE

Does the work of pymavlink's DFReader (DFReader.py; none of its text is here): a first pass notes
where the messages of each type are, a second takes each apart by struct, gives it the log's time
and keeps the last one of its type; fields are converted and scaled when they are asked for, which
here is all of them, by to_dict(). Prints how many messages there were.
"""

import mmap
import struct
import sys

LETTERS = {"a": ("64s", None), "b": ("b", None), "B": ("B", None), "h": ("h", None),
           "H": ("H", None), "i": ("i", None), "I": ("I", None), "f": ("f", None),
           "d": ("d", None), "n": ("4s", None), "N": ("16s", None), "Z": ("64s", None),
           "c": ("h", 0.01), "C": ("H", 0.01), "e": ("i", 0.01), "E": ("I", 0.01),
           "L": ("i", 1e-7), "M": ("B", None), "q": ("q", None), "Q": ("Q", None)}
FMT_TYPE = 128


class Format:
    def __init__(self, length, name, letters, columns):
        self.length, self.name, self.columns = length, name, columns.split(",")
        self.struct = "<" + "".join(LETTERS[c][0] for c in letters)
        self.multipliers = [LETTERS[c][1] for c in letters]
        self.types = [str if LETTERS[c][0].endswith("s") else
                      float if c in "fd" or LETTERS[c][1] else int for c in letters]
        self.index = {column: i for i, column in enumerate(self.columns)}


class Message:
    def __init__(self, form, elements):
        self.form, self.elements = form, elements

    def __getattr__(self, field):
        form = self.form
        i = form.index[field]
        value = self.elements[i]
        if form.types[i] is str:
            return text(value)
        value = form.types[i](value)
        return value if form.multipliers[i] is None else value * form.multipliers[i]

    def to_dict(self):
        values = {"mavpackettype": self.form.name}
        for field in self.form.columns:
            values[field] = getattr(self, field)
        return values


def text(raw):
    return raw.split(b"\0")[0].decode("ascii")


class Reader:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        self.formats = {FMT_TYPE: Format(89, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns")}
        self.offsets = {}
        self.latest = {}
        self.timestamp = 0.0
        self.note_offsets()

    def note_offsets(self):
        data, at, end = self.data, 0, len(self.data)
        while at + 3 <= end:
            form = self.formats.get(data[at + 2])
            if data[at] != 0xA3 or data[at + 1] != 0x95 or form is None or at + form.length > end:
                at += 1
                continue
            self.offsets.setdefault(data[at + 2], []).append(at)
            if data[at + 2] == FMT_TYPE:
                v = self.message_at(at, form).to_dict()
                self.formats[v["Type"]] = Format(v["Length"], v["Name"], v["Format"], v["Columns"])
            at += form.length

    def message_at(self, at, form):
        body = self.data[at + 3:at + form.length]
        return Message(form, list(struct.unpack(form.struct, body)))

    def messages(self):
        data, at, end = self.data, 0, len(self.data)
        while at + 3 <= end:
            head = data[at:at + 3]
            form = self.formats.get(head[2])
            if head[0] != 0xA3 or head[1] != 0x95 or form is None or at + form.length > end:
                at += 1
                continue
            message = self.message_at(at, form)
            if form.columns[0] == "TimeUS":
                self.timestamp = message.TimeUS * 1e-6
            message.timestamp = self.timestamp
            self.latest[form.name] = message
            yield message
            at += form.length


count = 0
for message in Reader(sys.argv[1]).messages():
    message.to_dict()
    count += 1
print(count)
