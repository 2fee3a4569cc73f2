"""Names of a spec as identifiers of MATLAB and Octave.

A name of UL-spec is an identifier of both languages unless it begins with ``_``, is longer than 63 characters, or is a
keyword. In addition, a property must differ from the members of the class, and a class must not hide a function that it
uses.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

LONGEST = 63
"""`namelengthmax` of MATLAB."""
_KEYWORDS = """
    ans arguments break case catch classdef continue do else elseif end end_try_catch end_unwind_protect endarguments
    endclassdef endenumeration endevents endfor endfunction endif endmethods endparfor endproperties endspmd endswitch
    endwhile enumeration events for function global if import methods otherwise parfor persistent properties return spmd
    switch try until unwind_protect unwind_protect_cleanup while
"""
_MEMBERS = """
    addlistener close delete eq findobj findprop ge groups gt isvalid le link listener lt ne networks notify
"""
_FUNCTIONS = """
    abs all any bitand bitget bitor bitshift bitxor cast ceil cell cell2struct cellfun char class clear double error
    exist false fieldnames fileparts find fix floor fullfile get hex2dec inf int64 intmax iscell ischar isempty
    isfield isfloat islogical ismember isnumeric ispc isreal isscalar isstring isstruct logical mat2cell max mex
    mfilename min mislocked mkoctfile mod nan nargin not numel publish regexp rehash repmat reshape rethrow round
    set size sprintf str2double strcmp strfind strjoin strncmp strtok strtrim struct struct2cell subsasgn subsref
    substruct sum tic toc true typecast uint32 uint64 unique vertcat zeros
"""
KEYWORDS = frozenset(_KEYWORDS.split())
"""`iskeyword` of MATLAB and Octave, words that begin blocks of a class, and `ans`, which expressions assign."""
MEMBERS = frozenset(_MEMBERS.split())
"""Members of the generated class, and members that every handle class inherits."""
FUNCTIONS = frozenset(_FUNCTIONS.split())
"""Functions that the package calls; a class of the same name would be called instead."""


def identifiers(names: Iterable[str], taken: Iterable[str] = ()) -> dict[str, str]:
    """Return unique identifiers for the names of one scope, by name; valid names that are not taken stay unchanged."""
    wanted = list(names)
    used = {*KEYWORDS, *taken}
    kept = {name for name in wanted if name == _shaped(name) and name not in used}
    result = {}
    for name in wanted:
        made = _shaped(name)
        if name not in kept:
            while made in used or made in kept:
                made = f"{made[: LONGEST - 1]}_" if len(made) < LONGEST else _counted(made)
            used.add(made)
        result[name] = made
    return result


def _shaped(name: str) -> str:
    shaped = f"x{name}" if name.startswith("_") else name
    return shaped[:LONGEST]


def _counted(name: str) -> str:
    """Return another name of the maximum length, with the number at its end incremented."""
    stem = name.rstrip("0123456789")
    number = str(int(name[len(stem) :] or 0) + 1)
    return name[: LONGEST - len(number)] + number
