"""Inspection of the machine code of a kernel, for the tests of its vectorisation."""

import re


def packed(dispatcher, signature=None) -> dict[str, int]:
    """How many packed (AVX-512 or AVX2) divisions, square roots and fused products a kernel's machine code holds."""
    text = dispatcher.inspect_asm(signature or dispatcher.signatures[0])
    return {op: len(re.findall(rf"\sv{op}\w*pd[^\n]*[yz]mm", text)) for op in ("div", "sqrt", "fmadd", "fnmadd")}
