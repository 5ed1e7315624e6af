#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes .mat files with scipy and h5py, and expected.json with what stands in them, into a folder.

  write_mats.py FOLDER

Debian's python3-scipy and python3-h5py; exit 77 where one is missing.
"""

import json
import os
import sys

try:
    import h5py
    import numpy as np
    import scipy.io
    import scipy.sparse
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(77)

INTEGERS = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"]
RANDOM = np.random.default_rng(1)


def columns_of(array):
    """The numbers of each field: samples run along the longer dimension, else the rows."""
    array = np.asarray(array)
    rows = array.T if array.shape[0] < array.shape[1] else array
    return [[number.item() + 0 for number in column] for column in rows.T]


def fields_of(name, array):
    columns = columns_of(array)
    if len(columns) == 1:
        return {name or "value": columns[0]}
    prefix = name + "." if name else ""
    return {prefix + str(i + 1): column for i, column in enumerate(columns)}


def matrix(array, kind):
    array = np.asarray(array)
    return {"type": "%s %dx%d" % (kind, *array.shape), "time": [None] * max(array.shape),
            "fields": fields_of("", array)}


def struct(stamps, **arrays):
    fields = {}
    for name, array in arrays.items():
        fields.update(fields_of(name, array))
    return {"type": "struct", "time": columns_of(stamps)[0], "fields": fields}


def extremes(kind):
    """The least and the largest there are, and some between."""
    info = np.iinfo(kind)
    middle = [0, 1, info.max // 3, info.min // 3, info.max // 7 + 1]
    return np.array([[info.min, info.max], *[[m, info.max - abs(m)] for m in middle]], dtype=kind)


def nested(time, eta):
    """What a struct of structs is given as: by MATLAB's names."""
    deep = {"eta": eta, "note": "text", "inner": {"nu": 2 * eta, "t": time, "gain": 3.0}}
    return {"time": time, "eta": eta, "u": eta[:, :1], "part": eta[:7], "deep": deep}


def expect_nested(name, time, eta):
    return {name: struct(time, time=time, eta=eta, u=eta[:, :1]),
            name + ".part": matrix(eta[:7], "double"),
            name + ".deep.eta": matrix(eta, "double"),
            name + ".deep.inner": struct(time, nu=2 * eta, t=time)}


def write_version_4(path):
    eta, wide = RANDOM.normal(size=(40, 6)), RANDOM.normal(size=(3, 90))
    complex_numbers = eta[:, :1] + 1j
    scipy.io.savemat(path, {"eta": eta, "wide": wide, "tiny": eta.astype("f4"), "text": "words",
                            "i2": extremes("int16"), "u1": extremes("uint8"),
                            "i4": extremes("int32"), "z": complex_numbers,
                            "sparse": scipy.sparse.csc_matrix(np.eye(5))}, format="4")
    return {"format": "mat4", "remarks": ["'z' is complex", "'sparse' is sparse", "1 text"],
            "channels": {"eta": matrix(eta, "double"), "wide": matrix(wide, "double"),
                         "tiny": matrix(eta.astype("f4"), "single"),
                         "i2": matrix(extremes("int16"), "int16"),
                         "u1": matrix(extremes("uint8"), "uint8"),
                         "i4": matrix(extremes("int32"), "int32")}}


def write_version_5(path, compressed):
    eta, time = RANDOM.normal(size=(200, 6)), np.arange(200.0)[:, None] / 7
    whole = np.arange(200.0)[:, None]  # scipy keeps doubles; MATLAB would store them as bytes
    long_name = "a_field_name_of_more_than_31_characters_0123456789"
    cells = np.empty((2, 2), dtype=object)
    cells[0, 0], cells[1, 0], cells[0, 1], cells[1, 1] = eta, "text", {"t": time, "u": eta}, time
    runs = np.zeros((1, 3), dtype=[("eta", object), ("name", object)])
    for i in range(3):
        runs[0, i] = (eta + i, "run")
    variables = {"eta": eta, "wide": eta.T, "e": time, "whole": whole, "single": eta.astype("f4"),
                 "flags": eta > 0, "run": nested(time, eta), "runs": runs, "cells": cells,
                 long_name: eta, "text": "words", "z": time + 2j, "cube": np.zeros((2, 3, 4)),
                 "sparse": scipy.sparse.csc_matrix(np.eye(5)), "none": np.zeros((0, 3)),
                 "large": RANDOM.normal(size=(30000, 4))}
    channels = {"eta": matrix(eta, "double"), "wide": matrix(eta.T, "double"),
                "e": matrix(time, "double"), "whole": matrix(whole, "double"),
                "single": matrix(eta.astype("f4"), "single"), "flags": matrix(eta > 0, "logical"),
                **expect_nested("run", time, eta), long_name: matrix(eta, "double"),
                "cells[1]": matrix(eta, "double"), "cells[3]": struct(time, t=time, u=eta),
                "cells[4]": matrix(time, "double"), "large": matrix(variables["large"], "double")}
    for i in range(3):
        channels["runs[%d].eta" % (i + 1)] = matrix(eta + i, "double")
    for kind in INTEGERS:
        variables[kind] = extremes(kind)
        channels[kind] = matrix(extremes(kind), kind)
    scipy.io.savemat(path, variables, do_compression=compressed, long_field_names=True)
    return {"format": "mat5", "channels": channels,
            "remarks": ["'z' is complex", "'cube' has 3 dimensions", "'sparse' is sparse",
                        "1 empty array"]}


def write_version_73(path, libver):
    eta, time = RANDOM.normal(size=(200, 6)), np.arange(200.0)[:, None] / 7
    channels = {}
    with h5py.File(path, "w", userblock_size=512, libver=libver) as file:

        def put(group, key, array, kind, **options):
            """MATLAB keeps columns together, and so sees the dimensions the other way round."""
            dataset = group.create_dataset(key, data=np.asarray(array).T, **options)
            dataset.attrs["MATLAB_class"] = np.bytes_(kind)
            return dataset

        def put_struct(group, key, members):
            inner = group.create_group(key)
            inner.attrs["MATLAB_class"] = np.bytes_("struct")
            for name, member in members.items():
                if isinstance(member, dict):
                    put_struct(inner, name, member)
                elif isinstance(member, str):
                    letters = np.array([[ord(letter) for letter in member]], dtype=np.uint16)
                    put(inner, name, letters, "char")
                else:
                    put(inner, name, np.atleast_2d(member), "double")

        layouts = {"contiguous": {}, "chunked": {"chunks": (4, 33)},
                   "packed": {"chunks": (6, 50), "compression": "gzip"},
                   "shuffled": {"chunks": (5, 64), "compression": "gzip", "shuffle": True},
                   "summed": {"chunks": (2, 200), "fletcher32": True},
                   "growing": {"maxshape": (None, None)}}
        for key, options in layouts.items():
            put(file, key, eta, "double", **options)
            channels[key] = matrix(eta, "double")
        put(file, "wide", eta.T, "double")
        channels["wide"] = matrix(eta.T, "double")
        put(file, "f4", eta.astype("f4"), "single", chunks=True, compression="gzip")
        channels["f4"] = matrix(eta.astype("f4"), "single")
        put(file, "big_endian", eta.astype(">f8"), "double")
        channels["big_endian"] = matrix(eta, "double")
        for kind in INTEGERS:
            put(file, kind, extremes(kind), kind)
            channels[kind] = matrix(extremes(kind), kind)
        flags = put(file, "flags", (eta > 0).astype(np.uint8), "logical")
        flags.attrs["MATLAB_int_decode"] = np.int32(1)
        channels["flags"] = matrix((eta > 0).astype(np.uint8), "logical")
        put_struct(file, "run", nested(time, eta))
        channels.update(expect_nested("run", time, eta))
        references = file.create_group("#refs#")
        cells = file.create_dataset("cells", (1, 2), dtype=h5py.ref_dtype)
        cells.attrs["MATLAB_class"] = np.bytes_("cell")
        for i in range(2):
            cells[0, i] = put(references, "abc"[i], eta + i, "double").ref
            channels["cells[%d]" % (i + 1)] = matrix(eta + i, "double")
        put(file, "cube", np.zeros((2, 3, 4)), "double")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM")
    return {"format": "mat7.3", "channels": channels, "remarks": ["'cube' has 3 dimensions"]}


def main(folder):
    def path(name):
        return os.path.join(folder, name)

    files = {"scipy_4.mat": write_version_4(path("scipy_4.mat")),
             "scipy_5.mat": write_version_5(path("scipy_5.mat"), False),
             "scipy_5_compressed.mat": write_version_5(path("scipy_5_compressed.mat"), True),
             "h5py_73.mat": write_version_73(path("h5py_73.mat"), "earliest"),
             "h5py_73_latest.mat": write_version_73(path("h5py_73_latest.mat"), "latest")}
    with open(path("expected.json"), "w") as file:
        json.dump(files, file)


main(sys.argv[1])
