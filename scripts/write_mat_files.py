#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the .mat files of the repository, with Debian's python3-scipy and python3-h5py.

  data/recordings/pool.mat   the numbers of pool.csv
  fuzz/corpus/matlab/*.mat   one small file of each version, for the tests and the fuzz target
"""

import os
import zlib

import h5py
import numpy as np
import scipy.io

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
SEEDS = os.path.join(ROOT, "fuzz", "corpus", "matlab")


def without_date(path):
    """scipy writes the date into the header; the same numbers shall give the same bytes."""
    with open(path, "r+b") as file:
        file.write(b"MATLAB 5.0 MAT-file, written by Fathom's scripts/write_mat_files.py".ljust(116))


def write_pool():
    command, velocity = [], []
    with open(os.path.join(ROOT, "data", "recordings", "pool.csv"), encoding="latin-1") as file:
        for line in file.read().splitlines()[3:]:
            time, thrust, speed = (cell.replace(",", ".") for cell in line.split(";")[:3])
            if thrust:
                command.append((float(time) / 1e3, float(thrust) * 1e3))
            if speed:
                velocity.append((float(time) / 1e3, float(speed) / 1e2))
    command, velocity = np.array(command), np.array(velocity)
    path = os.path.join(ROOT, "data", "recordings", "pool.mat")
    scipy.io.savemat(path, {"command": {"time": command[:, :1], "force": command[:, 1:]},
                            "velocity": {"time": velocity[:, :1], "u": velocity[:, 1:]},
                            "operator": "M. K."}, do_compression=True)
    without_date(path)


def numbers():
    """Row k of eta is (k, k + 0.25, -k); t is k / 10."""
    k = np.arange(12.0)[:, None]
    return {"eta": np.hstack([k, k + 0.25, -k]), "t": k / 10}


def write_version_4(name, order):
    n = numbers()
    with open(os.path.join(SEEDS, name), "wb") as file:
        for variable, array, kind in [("eta", n["eta"], "f8"), ("wide", n["eta"].T, "f4"),
                                      ("counts", n["eta"][:, :1], "i2")]:
            precision = {"f8": 0, "f4": 10, "i2": 30}[kind]
            mopt = precision + (1000 if order == ">" else 0)
            text = variable.encode() + b"\0"
            header = np.array([mopt, *array.shape, 0, len(text)], dtype=order + "i4")
            file.write(header.tobytes() + text + array.astype(order + kind).tobytes(order="F"))


def write_version_5(name, compressed):
    n = numbers()
    runs = np.zeros((1, 2), dtype=[("eta", object), ("name", object)])
    for i in range(2):
        runs[0, i] = (n["eta"] + 100 * i, "run")
    cells = np.empty((1, 2), dtype=object)
    cells[0, 0], cells[0, 1] = n["t"], "text"
    path = os.path.join(SEEDS, name)
    scipy.io.savemat(path, {
        "eta": n["eta"], "wide": n["eta"].T, "counts": n["eta"][:, :1].astype(np.int16),
        "flags": n["t"] > 0.5, "big": np.array([[1, 2**40]], dtype=np.int64),
        "run": {"t": n["t"], "eta": n["eta"], "gain": 2.0, "short": n["t"][:5]},
        "runs": runs, "cells": cells, "text": "pool", "z": n["t"] + 1j,
        "cube": np.zeros((2, 3, 4)), "none": np.zeros((0, 0)),
        "sl": {"time": n["t"], "signals": {"values": n["eta"], "label": "eta"}},
    }, do_compression=compressed)
    without_date(path)


def write_version_5_big(name):
    """What scipy does not write: most significant bytes first."""
    eta = numbers()["eta"]

    def element(kind, data):
        return np.array([kind, len(data)], dtype=">i4").tobytes() + data + b"\0" * (-len(data) % 8)

    matrix = (element(6, np.array([6, 0], dtype=">i4").tobytes())
              + element(5, np.array(eta.shape, dtype=">i4").tobytes()) + element(1, b"eta")
              + element(9, eta.astype(">f8").tobytes(order="F")))
    with open(os.path.join(SEEDS, name), "wb") as file:
        file.write(b"MATLAB 5.0 MAT-file".ljust(124) + b"\x01\x00MI" + element(14, matrix))


def write_version_73(name):
    n = numbers()
    path = os.path.join(SEEDS, name)

    def put(group, key, array, kind="double", **options):
        dataset = group.create_dataset(key, data=np.asarray(array).T, **options)
        dataset.attrs["MATLAB_class"] = np.bytes_(kind)
        return dataset

    with h5py.File(path, "w", userblock_size=512) as file:
        put(file, "eta", n["eta"])
        put(file, "packed", n["eta"], chunks=(3, 6), compression="gzip")
        put(file, "counts", n["eta"][:, :1].astype(np.int16), "int16")
        put(file, "text", np.array([[112, 111]], dtype=np.uint16), "char")
        run = file.create_group("run")
        run.attrs["MATLAB_class"] = np.bytes_("struct")
        put(run, "t", n["t"])
        put(run, "eta", n["eta"])
        cell = put(file.create_group("#refs#"), "a", n["t"])
        cells = file.create_dataset("cells", (1, 1), dtype=h5py.ref_dtype)
        cells[0, 0] = cell.ref
        cells.attrs["MATLAB_class"] = np.bytes_("cell")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM")


def write_bomb_73(name):
    """A chunk of 24 bytes that inflates to a megabyte."""
    with h5py.File(os.path.join(SEEDS, name), "w") as file:
        dataset = file.create_dataset("eta", (3, 1), chunks=(3, 1), compression="gzip", dtype="f8")
        dataset.id.write_direct_chunk((0, 0), zlib.compress(bytes(1 << 20), 9), 0)


os.makedirs(SEEDS, exist_ok=True)
write_pool()
write_version_4("little_4.mat", "<")
write_version_4("big_4.mat", ">")
write_version_5("plain_5.mat", False)
write_version_5("compressed_5.mat", True)
write_version_5_big("big_5.mat")
write_version_73("hdf5_73.mat")
write_bomb_73("bomb_73.mat")
