# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs every block of a page, one after the other in one namespace, or writes them as a program.

    page_test.py docs/python.md               runs them from the repository, in a scratch folder
    page_test.py docs/python.md --out=page.py  joins them, for mypy
"""

import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile


def blocks_of(page):
    """(line, code, output or None): a block of Python, and the one of text right behind it."""
    pattern = re.compile(
        r"^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<output>.*?)^```\n)?", re.M | re.S
    )
    for match in pattern.finditer(page):
        line = page.count("\n", 0, match.start()) + 2
        yield line, match["code"], match["output"]


def run(path):
    page = path.read_text()
    if page.count("```python") != len(list(blocks_of(page))):
        raise SystemExit(f"{path}: a block is not closed")
    root = path.resolve().parents[1]
    name = path.resolve()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        os.symlink(root / "data", "data")
        names = {}
        for line, code, output in blocks_of(page):
            # So that an error names the line of the page.
            code = compile("\n" * (line - 1) + code, str(name), "exec")
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(code, names)
            if output is not None and printed.getvalue().strip() != output.strip():
                raise SystemExit(
                    f"{name}:{line}: prints\n{printed.getvalue()}\nand the page shows\n{output}"
                )
        os.chdir(root)


def main():
    path = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        out = pathlib.Path(sys.argv[2].removeprefix("--out="))
        out.write_text("\n".join(code for _, code, _ in blocks_of(path.read_text())))
        return
    run(path)


if __name__ == "__main__":
    main()
