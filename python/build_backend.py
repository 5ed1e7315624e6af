# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause

"""A build backend (PEP 517) for pip: CMake builds and installs into a wheel. Needs nothing but CMake, Ninja
and Python itself, since Debian 12 has no scikit-build-core.

    pip install --no-build-isolation .
    pip install --no-build-isolation --config-settings=build=build/release .   # on top of a build there

Without the setting it builds in build/wheel-<tag>, so that the next time only what has changed is built. The
wheel holds the module, and the programs as scripts. The libraries that they link stay Debian's.
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]


def _project():
    """name, version and the lines of METADATA, of pyproject.toml, which Python 3.9 cannot parse."""
    text = (ROOT / "pyproject.toml").read_text()

    def value(key):
        return re.search(rf'^{key} = "(.*)"$', text, re.M).group(1)

    metadata = [
        "Metadata-Version: 2.1",
        f"Name: {value('name')}",
        f"Version: {value('version')}",
        f"Summary: {value('description')}",
        "License: BSD-3-Clause",
        f"Requires-Python: {value('requires-python')}",
        "Requires-Dist: numpy",
    ]
    return value("name").replace("-", "_"), value("version"), metadata


def _tag():
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{version}-{version}-{platform}"


def _cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True, cwd=ROOT)


def _install(staged, build):
    """Builds, and installs below `staged`. A folder that holds a build already stays as it was made."""
    if not (build / "CMakeCache.txt").exists():
        _cmake(
            "-S", ROOT, "-B", build, "-G", "Ninja",
            "-DCMAKE_BUILD_TYPE=Release", "-DFATHOM_BUILD_TESTS=OFF", "-DFATHOM_PYTHON=ON",
            f"-DPython_EXECUTABLE={sys.executable}",
        )  # fmt: skip
    _cmake("--build", build, "--target", "fathom_python", "tools")
    for component in ["python", "tools"]:
        _cmake("--install", build, "--prefix", staged, "--component", component, "--strip")


def _name_in_wheel(file, staged, package, scripts):
    """Where a file goes: the package at the top, programs among the scripts."""
    if file.is_relative_to(package):
        return f"fathom/{file.relative_to(package).as_posix()}"
    if file.is_relative_to(staged / "bin"):
        return f"{scripts}/{file.name}"
    return None


def _record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}"


def _texts(info, metadata):
    """The files of `info` that say what the wheel is, by their names in it."""
    kind = ["Wheel-Version: 1.0", "Generator: fathom", "Root-Is-Purelib: false", f"Tag: {_tag()}"]
    return {
        f"{info}/METADATA": "\n".join([*metadata, ""]),
        f"{info}/WHEEL": "\n".join([*kind, ""]),
    }


def _write_wheel(wheel, staged, info, metadata):
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:

        def add(name, data, mode=0o644):
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
            record.append(_record_line(name, data))

        [module] = staged.rglob("_fathom.*.so")
        scripts = f"{info.removesuffix('.dist-info')}.data/scripts"
        for file in sorted(path for path in staged.rglob("*") if path.is_file()):
            name = _name_in_wheel(file, staged, module.parent, scripts)
            if name:
                add(name, file.read_bytes(), 0o755 if name.startswith(scripts) else 0o644)
        for name, text in _texts(info, metadata).items():
            add(name, text.encode())
        archive.writestr(f"{info}/RECORD", "\n".join([*record, f"{info}/RECORD,,", ""]))


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Without it pip would build the wheel before it looks whether numpy can be had."""
    name, version, metadata = _project()
    info = f"{name}-{version}.dist-info"
    (pathlib.Path(metadata_directory) / info).mkdir()
    for file, text in _texts(info, metadata).items():
        (pathlib.Path(metadata_directory) / file).write_text(text)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name, version, metadata = _project()
    wheel = f"{name}-{version}-{_tag()}.whl"
    with tempfile.TemporaryDirectory() as folder:
        staged = pathlib.Path(folder) / "staged"
        build = (config_settings or {}).get("build") or f"build/wheel-{_tag()}"
        _install(staged, pathlib.Path(ROOT, build))
        _write_wheel(
            pathlib.Path(wheel_directory) / wheel, staged, f"{name}-{version}.dist-info", metadata
        )
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("a clone of the repository is the source: pip install . in it")
