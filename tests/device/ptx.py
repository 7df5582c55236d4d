"""Translates device code into C, statement by statement: what a GPU computes, without one.

`ptx.py IN.ptx OUT.c` knows the instructions whose answers have the same bits on every machine, and refuses all others:
no multiply-add of floating-point numbers, no approximation, no flush to zero, no trap, which is what a panic becomes,
no call of what the module does not define. What it has translated is therefore checked.

Registers are integers in C; a floating-point number is made of the bits for one operation. What is no number has other
bits than on the host, as on a GPU, unless HOST_NAN is defined. OUT.c belongs to driver.c.
"""

import re
import sys

HEAD = """#include <float.h>
#include <math.h>
#include <string.h>
#include "driver.h"
_Static_assert(FLT_EVAL_METHOD == 0, "an operation rounds once, to its own type");
#define LOAD(type, from) ({ type loaded; memcpy(&loaded, (void *)(from), sizeof loaded); loaded; })
#define STORE(type, to, what) { type stored = (type)(what); memcpy((void *)(to), &stored, sizeof stored); }
#ifdef HOST_NAN
#define BITS(x, bits, nan) bits
#else
#define BITS(x, bits, nan) (x == x ? bits : nan)
#endif
#define REAL(real, bits, type, nan) \\
  static inline real type##_of(bits from) { real x; memcpy(&x, &from, sizeof x); return x; } \\
  static inline bits type##_bits(real from) { bits x; memcpy(&x, &from, sizeof x); return BITS(from, x, nan); } \\
  static inline bits type##_min(bits a, bits b) { real x = type##_of(a), y = type##_of(b); \\
    return x != x ? b : y != y ? a : x == y ? a | b : x < y ? a : b; } \\
  static inline bits type##_max(bits a, bits b) { real x = type##_of(a), y = type##_of(b); \\
    return x != x ? b : y != y ? a : x == y ? a & b : x > y ? a : b; }
REAL(float, uint32_t, f32, 0x7fffffffu)
REAL(double, uint64_t, f64, 0x7fffffffffffffffull)
"""

ORDER = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}
SIGNLESS = ORDER | {"eq": "==", "ne": "!=", "lo": "<", "ls": "<=", "hi": ">", "hs": ">="}
NOT = {"lt": ">=", "le": ">", "gt": "<=", "ge": "<"}
ARITHMETIC = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
BITWISE = {"and": "&", "or": "|", "xor": "^"}
SPECIAL = {"%tid.x": "thread.tid", "%ntid.x": "thread.ntid", "%ctaid.x": "thread.ctaid"}
REAL = r"(f32|f64)"
WHOLE = r"([bus](?:8|16|32|64))"


def name(symbol: str) -> str:
    """A symbol of PTX as C takes it."""
    return re.sub(r"\W", "_", symbol)


def c_type(kind: str) -> str:
    """The C type that holds a value: floating-point numbers by their bits."""
    if kind == "pred":
        return "int"
    return f"{'' if kind[0] == 's' else 'u'}int{kind[1:]}_t"


def value(operand: str) -> str:
    """A register, constant or address."""
    if operand in SPECIAL:
        return SPECIAL[operand]
    if re.fullmatch(r"%\w+", operand):
        return operand[1:]
    if match := re.fullmatch(r"0[fd]([0-9A-F]+)", operand):
        return f"0x{match[1]}u" if len(match[1]) == 8 else f"0x{match[1]}ull"
    if re.fullmatch(r"-?\d+", operand):
        return f"{int(operand) % 2**64}ull"
    if re.fullmatch(r"[A-Za-z_][\w$]*", operand):
        return f"(uint64_t){name(operand)}"
    raise ValueError(f"operand {operand}")


def whole(operand: str, kind: str) -> str:
    """A value cut to a type, with or without a sign."""
    return f"(({c_type(kind)}){value(operand)})"


def real(operand: str, kind: str) -> str:
    """A floating-point number."""
    return f"{kind}_of({value(operand)})"


def address(operand: str) -> str:
    """The place in brackets."""
    base, offset = re.fullmatch(r"\[(%\w+|[A-Za-z_][\w$]*)(?:\+?(-?\d+))?\]", operand).groups()
    return f"{value(base)} + {int(offset or 0)}"


def comparison(how: str, x: str, y: str) -> str:
    """A comparison of numbers that may be no numbers: with u it holds for these too."""
    if how in ("num", "nan"):
        return f"({x} == {x} && {y} == {y}) == {int(how == 'num')}"
    if how in ("eq", "neu"):
        return f"{x} {'==' if how == 'eq' else '!='} {y}"
    if how in ("ne", "equ"):
        return f"({x} < {y} || {x} > {y}) == {int(how == 'ne')}"
    return f"{x} {ORDER[how]} {y}" if how in ORDER else f"!({x} {NOT[how[:-1]]} {y})"


def shifted(way: str, kind: str, a: str, by: str) -> str:
    """A shift, of which nothing remains if it is too far."""
    width, sign = int(kind[1:]), way == "shr" and kind[0] == "s"
    far = f"({whole(a, kind)} >> {width - 1})" if sign else "0"
    return f"{value(by)} < {width} ? {whole(a, kind)} {'<<' if way == 'shl' else '>>'} {value(by)} : {far}"


def multiplied(part: str, kind: str, a: str, b: str) -> str:
    """The lower half of a product, the upper one, or all."""
    width, unsigned = int(kind[1:]), kind[0] != "s"
    if part == "lo":
        return f"{value(a)} * {value(b)}"
    wide = {32: "uint64_t" if unsigned else "int64_t", 64: "unsigned __int128" if unsigned else "__int128"}[width]
    product = f"({wide}){whole(a, kind)} * {whole(b, kind)}"
    return product if part == "wide" else f"({product}) >> {width}"


def sign(kind: str) -> str:
    """The bit of the sign."""
    return f"((uint{kind[1:]}_t)1 << {int(kind[1:]) - 1})"


# What an instruction assigns to its first operand, from the groups of its name and the other operands.
EXPRESSIONS = {
    rf"(add|sub|mul|div)\.rn\.{REAL}": lambda o, t, a, b: f"{t}_bits({real(a, t)} {ARITHMETIC[o]} {real(b, t)})",
    rf"rcp\.rn\.{REAL}": lambda t, a: f"{t}_bits(1 / {real(a, t)})",
    rf"sqrt\.rn\.{REAL}": lambda t, a: f"{t}_bits(sqrt{'f' * (t == 'f32')}({real(a, t)}))",
    rf"neg\.{REAL}": lambda t, a: f"{value(a)} ^ {sign(t)}",
    rf"abs\.{REAL}": lambda t, a: f"{value(a)} & ~{sign(t)}",
    rf"copysign\.{REAL}": lambda t, a, b: f"({value(a)} & {sign(t)}) | ({value(b)} & ~{sign(t)})",
    rf"(min|max)\.{REAL}": lambda o, t, a, b: f"{t}_{o}({value(a)}, {value(b)})",
    rf"setp\.([a-z]+)\.{REAL}": lambda o, t, a, b: comparison(o, real(a, t), real(b, t)),
    r"cvt\.f64\.f32": lambda a: f"f64_bits(f32_of({value(a)}))",
    r"cvt\.rn\.f32\.f64": lambda a: f"f32_bits((float)f64_of({value(a)}))",
    rf"cvt\.rn\.{REAL}\.([us](?:32|64))": lambda t, f, a: f"{t}_bits({whole(a, f)})",
    rf"cvt\.{WHOLE}\.{WHOLE}": lambda t, f, a: f"({c_type(t)}){whole(a, f)}",
    rf"setp\.([a-z]+)\.{WHOLE}": lambda o, t, a, b: f"{whole(a, t)} {SIGNLESS[o]} {whole(b, t)}",
    rf"selp\.(?:{REAL}|{WHOLE})": lambda _f, _w, a, b, p: f"{value(p)} ? {value(a)} : {value(b)}",
    r"mov\.pred": lambda a: f"{value(a)} != 0",
    rf"mov\.(?:{REAL}|{WHOLE})": lambda _f, _w, a: value(a),
    r"cvta(?:\.to)?\.(?:global|local)\.u64": value,
    rf"(add|sub)\.{WHOLE}": lambda o, t, a, b: f"{value(a)} {ARITHMETIC[o]} {value(b)}",
    rf"(min|max)\.{WHOLE}": lambda o, t, a, b: (
        f"{whole(a, t)} {'<' if o == 'min' else '>'} {whole(b, t)} ? {value(a)} : {value(b)}"
    ),
    rf"mul\.(lo|hi|wide)\.{WHOLE}": multiplied,
    rf"mad\.lo\.{WHOLE}": lambda t, a, b, c: f"{value(a)} * {value(b)} + {value(c)}",
    rf"neg\.{WHOLE}": lambda t, a: f"0 - {value(a)}",
    rf"(and|or|xor)\.(?:pred|{WHOLE})": lambda o, t, a, b: f"{value(a)} {BITWISE[o]} {value(b)}",
    r"not\.pred": lambda a: f"!{value(a)}",
    rf"not\.{WHOLE}": lambda t, a: f"~{value(a)}",
    rf"(shl|shr)\.{WHOLE}": shifted,
    r"bfe\.u32": lambda a, start, count: f"({value(a)} >> {value(start)}) & ((1ull << {value(count)}) - 1)",
}


def transfer(opcode: str, operands: list[str]) -> str | None:
    """A load or store of one number or several, of memory or parameters."""
    match = re.fullmatch(r"(ld|st)(\.param|\.global|\.global\.nc|\.local)?(?:\.v([24]))?\.([busf]\d+)", opcode)
    if not match:
        return None
    way, space, _, kind = match.groups()
    place, held = operands if way == "st" else reversed(operands)
    if space == ".param":
        own = name(place[1:-1])
        return f"{own} = {value(held)};" if way == "st" else f"{value(held)} = {own};"
    held, width, text = re.findall(r"[^{}, ]+", held), int(kind[1:]) // 8, ""
    for index, one in enumerate(held):
        at = f"{address(place)} + {index * width}"
        stores = f"STORE({c_type(kind)}, {at}, {value(one)})"
        text += stores if way == "st" else f"{value(one)} = LOAD({c_type(kind)}, {at});"
    return text


def jump(opcode: str, operands: list[str], answer: str | None, defined: set[str]) -> str | None:
    """A branch, a call of a function of the module, or the end of one. After all cases of a switch stands `exit`."""
    if opcode in ("bra", "bra.uni"):
        return f"goto {name(operands[0])};"
    if opcode == "exit":
        return "__builtin_trap();"
    if opcode == "ret":
        return f"return {answer or ''};"
    if opcode != "call.uni" or operands[-2] not in defined:
        return None
    given = f"{name(operands[-2])}{operands[-1]};"
    return given if len(operands) == 2 else f"{operands[0][1:-1]} = {given}"


def statement(line: str, answer: str | None, defined: set[str]) -> str:
    """A line of a function's body."""
    if line in "{}":
        return line
    if match := re.fullmatch(r"(\$\w+):", line):
        return f"{name(match[1])}:;"
    if match := re.fullmatch(r"\.reg \.(\w+)\s+%(\w+)<(\d+)>;", line):
        registers = ", ".join(f"{match[2]}{n} = 0" for n in range(int(match[3])))
        return f"{c_type(match[1])} {registers};"
    if match := re.fullmatch(r"\.(?:reg|param) \.(\w+)\s+%?(\w+);", line):
        return f"{c_type(match[1])} {match[2]} = 0;"
    if match := re.fullmatch(r"\.local \.align (\d+) \.b8\s+(\w+)\[(\d+)\];", line):
        return "_Alignas({}) uint8_t {}[{}] = {{0}};".format(*match.groups())
    if match := re.fullmatch(r"(?:\{ \.reg \.b32 tmp; )?mov\.b64\s+\{%?(\w+), %(\w+)\}, %(\w+);(?: \})?", line):
        low = "" if match[1] == "tmp" else f"{match[1]} = (uint32_t){match[3]}; "
        return f"{low}{match[2]} = (uint32_t)({match[3]} >> 32);"
    if match := re.fullmatch(r"mov\.b64\s+%(\w+), \{%(\w+), %(\w+)\};", line):
        return f"{match[1]} = {match[2]} | (uint64_t){match[3]} << 32;"
    guard, opcode, rest = re.fullmatch(r"(?:@(!?%\w+)\s+)?([a-z][\w.]*)\s*(.*);", line).groups()
    operands = [part.strip() for part in re.findall(r"(?:[{(\[][^})\]]*[})\]]|[^,{(\[])+", rest)]
    text = jump(opcode, operands, answer, defined) or transfer(opcode, operands)
    for pattern, expression in EXPRESSIONS.items():
        if match := None if text else re.fullmatch(pattern, opcode):
            text = f"{value(operands[0])} = {expression(*match.groups(), *operands[1:])};"
    if not text:
        raise ValueError("not known to have the same bits on every machine, or a call of what is not there")
    return f"if ({guard.replace('%', '')}) {{ {text} }}" if guard else text


def function(match: re.Match, defined: set[str]) -> tuple[str, str]:
    """Prototype and definition of a function."""
    kind, answer, symbol, parameters, body = match.groups()
    declared = [line.split() for line in parameters.split(",") if line.strip()]
    kinds, names = [words[1][1:] for words in declared], [name(words[-1]) for words in declared]
    given = ", ".join(f"{c_type(kind)} {one}" for kind, one in zip(kinds, names, strict=True))
    head = f"static {c_type(answer) if answer else 'void'} {name(symbol)}({given or 'void'})"
    lines = [f"{c_type(answer)} func_retval0 = 0;"] if answer else []
    for line in filter(None, map(str.strip, body.splitlines())):
        try:
            lines.append(statement(line, "func_retval0" if answer else None, defined))
        except (ValueError, KeyError, AttributeError, TypeError) as error:
            sys.exit(f"{symbol}: refused: {line}\n{error}")
    text = f"{head} {{\n" + "\n".join(lines) + "\n}\n"
    if kind == "entry":
        values = ", ".join(f"*({c_type(kind)} *)given[{n}]" for n, kind in enumerate(kinds))
        text += f"static void run_{name(symbol)}(void **given) {{ {name(symbol)}({values}); }}\n"
    return f"{head};\n", text


def translated(source: str) -> str:
    """The module in C."""
    source = re.sub(r"//.*", "", source)
    text = HEAD
    data = r"\.global \.align (\d+) \.b8 ([\w$]+)\[(\d+)\] = \{([\d, ]*)\};"
    for align, symbol, count, numbers in re.findall(data, source):
        text += f"static _Alignas({align}) const uint8_t {name(symbol)}[{count}] = {{{numbers}}};\n"
    source = re.sub(data, "", source)
    head = r"(?:\.visible )?\.(entry|func)\s+(?:\(\.param \.(\w+) func_retval0\)\s*)?([\w$]+)\s*\(([^)]*)\)\s*"
    found = list(re.finditer(head + r"\{\n(.*?)^\}", source, re.DOTALL | re.MULTILINE))
    functions = [function(match, {match[3] for match in found}) for match in found]
    rest = re.sub(head + r"(?:;|\{\n.*?^\})", "", source, flags=re.DOTALL | re.MULTILINE)
    if extra := re.sub(r"\.(version|target|address_size) .*", "", rest).strip():
        sys.exit(f"refused: {extra[:200]}")
    text += "".join(head for head, _ in functions) + "".join(body for _, body in functions)
    entries = [name(match[3]) for match in found if match[1] == "entry"]
    listed = "".join(f'  {{"{entry}", run_{entry}}},\n' for entry in entries)
    print(f"{len(found)} functions, {len(entries)} of them programs; refused nothing")
    return text + f"const struct program programs[] = {{\n{listed}  {{0, 0}}\n}};\n"


if __name__ == "__main__":
    with open(sys.argv[1]) as ptx, open(sys.argv[2], "w") as c:
        c.write(translated(ptx.read()))
