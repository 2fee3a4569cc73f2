"""The commands of YoWASP, as `unity_link.gateware.yowasp` runs them."""

from __future__ import annotations

from unity_link.gateware.yowasp import run, script, version

__all__ = ["run", "script", "version"]
