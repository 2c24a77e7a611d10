"""Python's scalar functions as JavaScript.

What is read are the plain scalar functions that kernels compile: numbers, tuples, branches, loops, calls. What this reading does not know
raises `NotImplementedError` at once, so nothing is ever transcribed in part.
"""

import ast
import inspect
import json
import math
import types
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.contract import EOS

_SIGN: dict[type, str] = {ast.USub: "-", ast.UAdd: "+", ast.Not: "!"}
_BINARY: dict[type, str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**", ast.Mod: "%"}
_COMPARED: dict[type, str] = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "===", ast.NotEq: "!==", ast.Is: "===",
                              ast.IsNot: "!=="}
_KNOWN: dict[Any, str] = {abs: "Math.abs", min: "lesser", max: "greater", float: "number", int: "number", bool: "Boolean",
                          math.isfinite: "Number.isFinite", math.isnan: "Number.isNaN", math.fabs: "Math.abs", math.copysign: "copysign"}
_KNOWN |= {getattr(room, name): f"Math.{name}" for room in (math, np) for name in ("sqrt", "exp", "log", "log1p", "expm1", "tanh", "cbrt")}
_RESERVED = {"new", "var", "let", "const", "function", "default", "case", "switch", "this", "void", "delete", "typeof", "catch", "do",
             "export", "enum", "super", "with", "eval", "arguments", "law"}
# minima and maxima as Python takes them: of a list or of several; where one is not a number, the first
HELPERS = """\
const among = values => values.length === 1 && Array.isArray(values[0]) ? values[0] : values;
const lesser = (...values) => among(values).reduce((a, b) => b < a ? b : a);
const greater = (...values) => among(values).reduce((a, b) => b > a ? b : a);
const number = x => ({inf: Infinity, "-inf": -Infinity})[x] ?? Number(x);
const copysign = (a, b) => b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a);
class NoState extends Error {}
"""


class Transcriber:
    """Writes every function it is asked the name of, once."""

    def __init__(self):
        self.names: dict[Callable, str] = {}
        self.waiting: list[Callable] = []
        self.written: list[str] = []

    def name_of(self, function: Callable) -> str:
        if function not in self.names:
            name = f"{function.__module__.rpartition('.')[2]}${function.__name__}"
            if name in self.names.values():
                raise NotImplementedError(f"{name}: two functions of one name, in modules of one name")
            self.names[function] = name
            self.waiting.append(function)
        return self.names[function]

    def follow(self) -> None:
        """Write whatever has been asked for, and what that calls."""
        while self.waiting:
            function = self.waiting.pop()
            self.written.append(_Function(self, function).text())


@cache
def _definitions(module: types.ModuleType) -> dict[str, ast.FunctionDef]:
    return {node.name: node for node in ast.parse(inspect.getsource(module)).body if isinstance(node, ast.FunctionDef)}


class _Function:
    """One function as JavaScript."""

    def __init__(self, reader: Transcriber, function: Callable):
        self.reader, self.function, self.loops = reader, function, 0
        module = inspect.getmodule(function)
        if not isinstance(function, types.FunctionType) or module is None or function.__name__ not in _definitions(module):
            raise NotImplementedError(f"{function!r} is no plain function of a module")
        self.node = _definitions(module)[function.__name__]
        self.arguments = [a.arg for a in self.node.args.args]
        self.locals = {n.id for n in ast.walk(self.node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)} | set(self.arguments)

    def text(self) -> str:
        defaults = [None] * (len(self.arguments) - len(self.node.args.defaults)) + self.node.args.defaults
        head = ", ".join(_safe(a) + ("" if d is None else f" = {self.value(d)}") for a, d in zip(self.arguments, defaults))
        own = sorted(_safe(name) for name in self.locals - set(self.arguments))
        lines = [f"let {', '.join(own)};\n"] if own else []
        return f"function {self.reader.names[self.function]}({head}) {{\n{''.join(lines)}{self.block(self.node.body)}}}\n"

    # -- statements
    def block(self, body: list[ast.stmt]) -> str:
        return "".join(map(self.statement, body))

    def statement(self, node: ast.stmt) -> str:
        match node:
            case ast.Expr(value=ast.Constant()):
                return ""
            case ast.Return(value=value):
                return f"return {self.value(value)};\n"
            case ast.Assign(targets=targets, value=value):
                return f"{' = '.join(map(self.value, targets))} = {self.value(value)};\n"
            case ast.AugAssign(target=target, op=op, value=value):
                return f"{self.value(target)} = {self.binary(op, self.value(target), self.value(value))};\n"
            case ast.If(test=test, body=body, orelse=orelse):
                other = f" else {{\n{self.block(orelse)}}}" if orelse else ""
                return f"if ({self.value(test)}) {{\n{self.block(body)}}}{other}\n"
            case ast.While(test=test, body=body, orelse=[]):
                return f"while ({self.value(test)}) {{\n{self.block(body)}}}\n"
            case ast.For(target=target, iter=ast.Call(func=ast.Name(id="range"), args=args), body=body, orelse=[]) if len(args) < 3:
                name, (first, last) = self.value(target), ("0", self.value(args[0])) if len(args) == 1 else map(self.value, args)
                self.loops += 1     # counted apart: the body may give the name another value
                turn = f"turn{self.loops}"
                return f"for (let {turn} = {first}; {turn} < {last}; {turn}++) {{\n{name} = {turn};\n{self.block(body)}}}\n"
            case ast.For(target=target, iter=over, body=body, orelse=[]):
                return f"for ({self.value(target)} of {self.value(over)}) {{\n{self.block(body)}}}\n"
            case ast.Break():
                return "break;\n"
            case ast.Continue():
                return "continue;\n"
            case ast.Raise(exc=ast.Call(func=error, args=[words])) if issubclass(self.meaning(error), HugoniotError):
                return f"throw new NoState({self.value(words)});\n"
        raise self.unknown(node)

    # -- expressions
    def value(self, node: ast.expr) -> str:
        match node:
            case ast.Constant(value=constant):
                return json.dumps(constant)
            case ast.Name(id=name):
                return _safe(name) if name in self.locals else self.known(self.meaning(node), node)
            case ast.Tuple(elts=elements) | ast.List(elts=elements):
                return f"[{', '.join(map(self.value, elements))}]"
            case ast.BinOp(left=ast.List(elts=[element]), op=ast.Mult(), right=count):
                return f"Array({self.value(count)}).fill({self.value(element)})"
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(op, self.value(left), self.value(right))
            case ast.UnaryOp(op=op, operand=operand):
                return f"({_SIGN[type(op)]}{self.value(operand)})"
            case ast.BoolOp(op=op, values=values):
                return f"({(' && ' if isinstance(op, ast.And) else ' || ').join(map(self.value, values))})"
            case ast.IfExp(test=test, body=body, orelse=orelse):
                return f"({self.value(test)} ? {self.value(body)} : {self.value(orelse)})"
            case ast.Compare(left=left, ops=ops, comparators=others):
                pairs = zip([left, *others], ops, others)
                return f"({' && '.join(self.compared(a, op, b) for a, op, b in pairs)})"
            case ast.JoinedStr(values=values):
                return " + ".join(map(self.value, values)) or '""'
            case ast.FormattedValue(value=value):
                return f"H.digits({self.value(value)})" if node.format_spec else f"String({self.value(value)})"
            case ast.Starred(value=value):
                return f"...{self.value(value)}"
            case ast.GeneratorExp(elt=element, generators=[one]) | ast.ListComp(elt=element, generators=[one]):
                name = self.value(one.target)
                chosen = "".join(f".filter({name} => {self.value(test)})" for test in one.ifs)
                return f"{self.value(one.iter)}{chosen}.map({name} => {self.value(element)})"
            case ast.Subscript(value=ast.Attribute(value=value, attr="shape"), slice=ast.Constant(value=axis)):
                return f"{self.value(value)}{'[0]' * axis}.length"
            case ast.Subscript(value=value, slice=place):
                return self.part(self.value(value), place)
            case ast.Attribute():
                return self.attribute(node)
            case ast.Call():
                return self.call(node)
        raise self.unknown(node)

    def binary(self, op: ast.operator, left: str, right: str) -> str:
        if isinstance(op, ast.FloorDiv):
            return f"Math.floor({left} / {right})"
        if type(op) not in _BINARY:
            raise self.unknown(op)
        return f"(({left}) {_BINARY[type(op)]} {right})"

    def compared(self, left: ast.expr, op: ast.cmpop, right: ast.expr) -> str:
        if isinstance(op, (ast.In, ast.NotIn)) and isinstance(right, ast.Attribute) and right.attr == "functions":     # of a law
            return f"{'' if isinstance(op, ast.In) else '!'}({self.value(left)} in {self.value(right.value)})"
        if isinstance(left, ast.Tuple) and isinstance(right, ast.Tuple) and isinstance(op, ast.Eq) and len(left.elts) == len(right.elts):
            return f"({' && '.join(self.compared(a, op, b) for a, b in zip(left.elts, right.elts))})"
        if isinstance(left, ast.Tuple) or isinstance(right, ast.Tuple) and not isinstance(op, (ast.In, ast.NotIn)):
            raise self.unknown(left)      # two lists are never the same in JavaScript
        if isinstance(op, (ast.In, ast.NotIn)):
            return f"{'' if isinstance(op, ast.In) else '!'}{self.value(right)}.includes({self.value(left)})"
        return f"{self.value(left)} {_COMPARED[type(op)]} {self.value(right)}"

    def part(self, whole: str, place: ast.expr) -> str:
        match place:
            case ast.Tuple(elts=[ast.Slice() as rows, ast.Slice() as columns]):
                return f"{self.part(whole, rows)}.map(row => {self.part('row', columns)})"
            case ast.Tuple(elts=elements):
                return whole + "".join(f"[{self.value(e)}]" for e in elements)
            case ast.Slice(lower=lower, upper=upper, step=None):
                return f"{whole}.slice({self.value(lower) if lower else 0}{', ' + self.value(upper) if upper else ''})"
            case ast.UnaryOp(op=ast.USub()):
                return f"{whole}.at({self.value(place)})"
        return f"{whole}[{self.value(place)}]"

    def attribute(self, node: ast.Attribute) -> str:
        if self.is_local(node):
            return f"{self.value(node.value)}.{node.attr}"
        return self.known(self.meaning(node), node)

    def is_local(self, node: ast.expr) -> bool:
        while isinstance(node, (ast.Attribute, ast.Subscript)):
            node = node.value
        return isinstance(node, ast.Call) or isinstance(node, ast.Name) and node.id in self.locals

    def call(self, node: ast.Call) -> str:
        arguments = list(map(self.value, node.args))
        match node.func:
            case ast.Subscript(value=ast.Attribute(value=ast.Call(func=ast.Attribute(attr="of"), args=[par]), attr="functions"),
                               slice=ast.Constant(value=name)):       # of the law that the parameters carry
                return f"{self.value(par)}.law.{name}({', '.join(arguments)})"
            case ast.Attribute(value=ast.Attribute(value=ast.Call(func=ast.Attribute(attr="of"), args=[par]), attr="functions"),
                               attr="get"):
                return f"{self.value(par)}.law[{arguments[0]}]"
            case ast.Attribute(value=ast.Name(id="EOS"), attr="of"):
                return f"{arguments[0]}.law"
            case ast.Name(id=name) if name in self.locals:
                return f"{_safe(name)}({', '.join(arguments)})"
        meant = self.meaning(node.func)
        if meant in _KNOWN:
            return f"{_KNOWN[meant]}({', '.join(arguments)})"
        if node.keywords:
            raise self.unknown(node)
        if isinstance(meant, type) and issubclass(meant, tuple) and hasattr(meant, "_fields"):
            return self.made(meant, arguments, node)
        if isinstance(meant, types.FunctionType):
            return f"{self.reader.name_of(meant)}({', '.join(arguments)})"
        raise self.unknown(node)

    def made(self, cls, arguments: list[str], node: ast.Call) -> str:
        """A named tuple: the parameters of a law carry their law, any other has its fields alone."""
        given = [f"{field}: {value}" for field, value in zip(cls._fields, arguments)]
        defaults = [f"{field}: {self.known(value, node)}" for field, value in cls._field_defaults.items()]
        law = [f"law: laws.{law.name}" for law in EOS if law.parameters is cls]
        return f"({{{', '.join([*law, *defaults, *given])}}})"

    # -- names
    def meaning(self, node: ast.expr) -> Any:
        """The object that a name of the module stands for."""
        if isinstance(node, ast.Name):
            builtin = __builtins__ if isinstance(__builtins__, dict) else vars(__builtins__)
            if node.id in self.function.__globals__ or node.id in builtin:
                return self.function.__globals__.get(node.id, builtin.get(node.id))
        elif isinstance(node, ast.Attribute):
            return getattr(self.meaning(node.value), node.attr)
        raise self.unknown(node)

    def known(self, meant: Any, node: ast.expr) -> str:
        """A constant of the module."""
        if isinstance(meant, float) and not math.isfinite(meant):
            return {math.inf: "Infinity", -math.inf: "(-Infinity)"}.get(meant, "NaN")
        if isinstance(meant, (bool, int, float, str)) or meant is None:
            return f"({json.dumps(meant)})"
        if isinstance(meant, tuple) and not EOS.knows(meant):
            return f"[{', '.join(self.known(inner, node) for inner in meant)}]"
        raise self.unknown(node)

    def unknown(self, node: ast.AST) -> NotImplementedError:
        place = f"{self.function.__module__}.{self.function.__name__}"
        return NotImplementedError(f"{place}: {ast.unparse(node) if isinstance(node, (ast.expr, ast.stmt)) else node} cannot be "
                                   "translated into JavaScript")


def _safe(name: str) -> str:
    return f"{name}_" if name in _RESERVED else name
