"""Answers as JSON that every browser reads: no NaN, no characters that a script tag would obey."""

import json
import math
from typing import Any

NUMBER_DIGITS = 10     # of curves that are only drawn; what is read out is sent whole


def encoded(value: Any) -> bytes:
    """A value as JSON; numbers that are not finite become null, arrays lists. Pure ASCII, and safe inside a script."""
    text = json.dumps(plain(value), ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").encode("ascii")


def plain(value: Any) -> Any:
    """Numbers, words, lists and dictionaries only."""
    if isinstance(value, dict):
        return {str(key): plain(inner) for key, inner in value.items()}
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(inner) for inner in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
