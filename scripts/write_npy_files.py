#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes fuzz/corpus/numpy, for the tests and the fuzz target, with Debian's python3-numpy.

Row k of `eta` is k, k + 0.25, -k; sample k of `t` is k / 10.
"""

import io
import os
import zipfile

import numpy as np

SEEDS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "fuzz", "corpus", "numpy")

K = np.arange(12.0)
ETA = np.stack([K, K + 0.25, -K], axis=1)


def structured():
    run = np.zeros(12, dtype=np.dtype([("t", "<f8"), ("mode", "S3"), ("u", ">f4"), ("n", "<i2"),
                                       ("pose", [("x", "<f8"), ("y", "<f8")]), ("eta", "<f4", (3,))],
                                      align=True))
    run["t"], run["u"], run["n"] = K / 10, K / 4, -K
    run["pose"]["x"], run["pose"]["y"], run["eta"] = K, -K, ETA
    return run


def dated():
    run = np.zeros(12, dtype=[("stamp", "<M8[ns]"), ("u", "<f8")])
    run["stamp"] = np.datetime64("2026-05-10T00:00:00", "ns") + (K * 1e8).astype("m8[ns]")
    run["u"] = K
    return run


def arrays():
    return {"eta": ETA, "wide": ETA.T.copy(), "fortran": np.asfortranarray(ETA),
            "wide_fortran": np.asfortranarray(ETA.T), "big": ETA.astype(">f4"), "t": K / 10,
            "flags": K > 5, "cube": np.zeros((2, 3, 4)), "thin": ETA.reshape(12, 1, 3),
            "z": K + 1j, "words": np.array(["a", "b"]), "g": np.float64(9.81), "none": np.zeros((0, 3)),
            "objects": np.array([{}, None], dtype=object),
            **{f"of_{kind}": K.astype(kind) for kind in
               ("i1", "i2", ">i4", "i8", "u1", ">u2", "u4", ">u8", "<f4", ">f8")}}


def npz(name, method):
    """As numpy.savez does, but with one date for all: the same numbers shall give the same bytes."""
    with zipfile.ZipFile(os.path.join(SEEDS, name), "w", method) as file:
        for key, array in arrays().items():
            bytes_of_array = io.BytesIO()
            np.save(bytes_of_array, array)
            info = zipfile.ZipInfo(key + ".npy")
            info.compress_type = method
            with file.open(info, "w", force_zip64=True) as member:
                member.write(bytes_of_array.getvalue())


def main():
    os.makedirs(SEEDS, exist_ok=True)
    np.save(os.path.join(SEEDS, "eta.npy"), ETA)
    np.save(os.path.join(SEEDS, "run.npy"), structured())
    np.save(os.path.join(SEEDS, "dated.npy"), dated())
    for version in (2, 3):
        with open(os.path.join(SEEDS, f"version_{version}.npy"), "wb") as file:
            np.lib.format.write_array(file, ETA, version=(version, 0))
    npz("stored.npz", zipfile.ZIP_STORED)
    npz("packed.npz", zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    main()
