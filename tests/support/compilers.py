"""Marks of the tests that compile C or C++."""

from __future__ import annotations

import shutil

import pytest


def _lacks_all(*names: str) -> bool:
    return not any(shutil.which(name) for name in names)


needs_c = pytest.mark.skipif(_lacks_all("cc", "gcc", "clang"), reason="no C compiler: apt install gcc")
needs_cxx = pytest.mark.skipif(_lacks_all("c++", "g++", "clang++"), reason="no C++ compiler: apt install g++")
