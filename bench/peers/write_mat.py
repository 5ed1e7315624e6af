#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes .mat files of four matrices of 16 MB with scipy and h5py, for bench/import_bench.

  write_mat.py FOLDER

plain_5.mat, packed_5.mat, plain_73.mat, packed_73.mat.
"""

import os
import sys

import h5py
import numpy as np
import scipy.io

matrices = {"m%d" % i: np.sin(1e-4 * np.arange(2000000.0) + i).round(6).reshape(-1, 8)
            for i in range(4)}
for name, is_packed in [("plain_5.mat", False), ("packed_5.mat", True)]:
    scipy.io.savemat(os.path.join(sys.argv[1], name), matrices, do_compression=is_packed)
for name, options in [("plain_73.mat", {}),
                      ("packed_73.mat", {"chunks": (8, 8192), "compression": "gzip",
                                         "compression_opts": 3})]:
    path = os.path.join(sys.argv[1], name)
    with h5py.File(path, "w", userblock_size=512) as file:
        for key, matrix in matrices.items():
            dataset = file.create_dataset(key, data=matrix.T, **options)
            dataset.attrs["MATLAB_class"] = np.bytes_("double")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM")
