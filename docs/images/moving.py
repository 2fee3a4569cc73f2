"""The style of an animated picture without a script."""


def style(seconds: float, moves: dict[str, list[str]], shown: dict[str, tuple[float, float]], hidden: str) -> str:
    """Return the style of a picture whose elements move by their classes.

    Args:
        seconds: length of the animation, after which it repeats.
        moves: declarations of each class, such as ``opacity:1``, at equal distances over that time.
        shown: first and last second in which the elements of a class are visible.
        hidden: classes that are invisible if the reader prefers reduced motion, with dots and commas.
    """
    rules = [f".{name}{{animation:{name} {seconds:g}s linear infinite}}" for name in moves]
    rules += [f".{name}{{animation:{name} {seconds:g}s step-end infinite}}" for name in shown]
    return "\n".join(
        [
            "text{font:15px sans-serif;fill:#57606a;text-anchor:middle}",
            *rules,
            *(_keyframes(name, declarations) for name, declarations in moves.items()),
            *(_shown(name, begin / seconds, end / seconds) for name, (begin, end) in shown.items()),
            f"@media (prefers-reduced-motion){{*{{animation:none!important}}{hidden}{{opacity:0}}}}",
        ]
    )


def _keyframes(name: str, declarations: list[str]) -> str:
    last = len(declarations) - 1
    rows = [f"{100 * number / last:.4g}%{{{declaration}}}" for number, declaration in enumerate(declarations)]
    return f"@keyframes {name}{{{''.join(rows)}}}"


def _shown(name: str, begin: float, end: float) -> str:
    """Return keyframes of elements that are visible from one part of the time to another."""
    hidden = "" if begin == 0 else "0%{opacity:0}"
    gone = "" if end >= 1 else f"{100 * end:.4g}%{{opacity:0}}"
    return f"@keyframes {name}{{{hidden}{100 * begin:.4g}%{{opacity:1}}{gone}}}"
