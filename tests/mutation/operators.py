"""The faults that are made on purpose: a table of operators.

Each finds its places in a source and says for each what stands there, what the fault makes of it,
and the code that is one or the other at run time. The code keeps the value and the order of
evaluation of what stands there where its fault is not chosen.
"""
from dataclasses import dataclass

NUMBER = "@fault@"  # in Place.code: the call that tells whether this place's fault is chosen


@dataclass(frozen=True)
class Place:
    operator: str
    begin: int  # offsets in the source
    end: int
    line: int
    before: str  # the lines round it, as one
    after: str
    code: str
    constexpr: bool  # in a constexpr function

    def replacement(self, number):
        call = "remeshd_constexpr_mutant" if self.constexpr else "remeshd_mutant"
        return self.code.replace(NUMBER, f"{call}({number})")


# What ends an operand, by how tightly the operator binds.
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
ENDS = ASSIGNMENTS | {",", ";", "?", ":", "return", "co_return", "else", "throw", "co_yield"}
ENDS_OF = {
    "||": ENDS | {"||"},
    "&&": ENDS | {"||", "&&"},
    "==": ENDS | {"||", "&&"},
    "<": ENDS | {"||", "&&", "==", "!="},
}
COMPARISONS = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
BOUNDS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
# What the order of arguments or a call's absence cannot change, but for time.
SYMMETRIC = {"min", "max", "minmax", "fmin", "fmax", "hypot", "dot", "distance", "distance2",
             "swap"}
ONLY_FOR_SPEED = {"reserve", "shrink_to_fit"}
KEYWORDS = {"if", "for", "while", "switch", "return", "catch", "co_return", "throw", "delete",
            "new", "else", "do", "case", "default", "operator", "goto", "break", "continue", "using",
            "typedef", "static_assert", "assert", "co_await", "co_yield", "sizeof", "template"}


def operand(source, i, step, ends):
    """Tokens from operator i to what ends its operand on that side, exclusive of both; None where
    the extent is not sure."""
    j = i + step
    while 0 <= j < len(source.tokens):
        token = source.tokens[j]
        inwards = source.closes(j) if step < 0 else source.opens(j)
        if inwards:
            if step < 0 and source.braces.get(source.partner[j]) == "code" \
                    and not source.is_(j + 1, "(", ")", ",", "."):
                break  # the end of the statement before
            j = source.partner[j]
        elif source.closes(j) or source.opens(j) or token.text in ends:
            break
        elif token.text in ("<=>", "&", "|", "^") and token.spaced:
            return None  # binds less tightly than it looks, or is no operator at all
        elif token.kind == "word" and token.text in ("if", "for", "while", "do", "template"):
            return None
        j += step
    first, last = (j + 1, i - 1) if step < 0 else (i + 1, j - 1)
    return (first, last) if source.whole(first, last) else None


def binary(source, signs):
    """(i, left, right) of every binary operator of these; left and right are pairs of tokens."""
    for i, token in enumerate(source.tokens):
        if token.text not in signs or not token.spaced or source.partner[i] >= 0:
            continue
        if not source.touchable(i):
            continue
        kind = token.text if token.text in ENDS_OF else "==" if token.text == "!=" else "<"
        left = operand(source, i, -1, ENDS_OF[kind])
        right = operand(source, i, +1, ENDS_OF[kind])
        if left and right and not declares(source, *left):
            yield i, left, right


def declares(source, first, last):
    """Whether these tokens look like the beginning of a declaration: two names side by side."""
    return any(source.tokens[j].kind == source.tokens[j + 1].kind == "word"
               and source.outer[j] == source.outer[first]
               and source.tokens[j].text not in ("not", "new", "co_await", "typename")
               for j in range(first, last))


def place(source, operator, first, last, after, code):
    begin, end = source.tokens[first].begin, source.tokens[last].end
    line_begin = source.text.rfind("\n", 0, begin) + 1
    line_end = (source.text + "\n").find("\n", end)
    before = source.text[line_begin:line_end]
    after = source.text[line_begin:begin] + after + source.text[end:line_end]
    return Place(operator, begin, end, source.line(begin), " ".join(before.split()),
                 " ".join(after.split()), code, source.in_constexpr_function(first))


def comparison_flipped(source):
    """a < b -> !(a < b)"""
    for i, left, right in binary(source, COMPARISONS):
        a, sign, b = source.slice(*left), source.tokens[i].text, source.slice(*right)
        yield place(source, "comparison_flipped", left[0], right[1],
                    f"{a} {COMPARISONS[sign]} {b}", f"(({a} {sign} {b}) != {NUMBER})")


def bound_moved(source):
    """a < b -> a <= b"""
    for i, left, right in binary(source, BOUNDS):
        a, sign, b = source.slice(*left), source.tokens[i].text, source.slice(*right)
        yield place(source, "bound_moved", left[0], right[1], f"{a} {BOUNDS[sign]} {b}",
                    f"({NUMBER} ? ({a} {BOUNDS[sign]} {b}) : ({a} {sign} {b}))")


def off_by_one(source):
    """a + 1 -> a + 0, and a loop that begins at 0 or 1 -> at the other"""
    for i, token in enumerate(source.tokens[:-1]):
        literal = source.tokens[i + 1]
        if literal.text not in ("0", "1") or literal.kind != "number" or not source.touchable(i):
            continue
        if token.text in ("+", "-") and token.spaced and literal.text == "1":
            first, other = i, "0"
        elif token.text == "=" and begins_loop(source, i) and source.is_(i + 2, ";", ","):
            first, other = i - 1, str(1 - int(literal.text))
        else:
            continue
        kept = source.text[source.tokens[first].begin:literal.begin]
        yield place(source, "off_by_one", first, i + 1, kept + other,
                    f"{kept}({NUMBER} ? {other} : {literal.text})")


def begins_loop(source, i):
    """Whether token i stands between `for (` and its first `;`."""
    bracket = source.outer[i]
    if bracket < 0 or not source.is_(bracket, "(") or not source.is_(bracket - 1, "for"):
        return False
    return not any(source.is_(j, ";") and source.outer[j] == bracket for j in range(bracket, i))


def condition(source, i):
    """The tokens of the condition of the `if` or `while` i; None where it declares something."""
    if not source.is_(i + 1, "(") or not source.touchable(i + 1) or source.is_(i, "}"):
        return None
    first, last = i + 2, source.partner[i + 1] - 1
    inside = [j for j in range(first, last + 1) if source.outer[j] == i + 1]
    for j in inside:
        if source.is_(j, ";"):
            first = j + 1
    if any(source.tokens[j].text in ASSIGNMENTS and j >= first for j in inside):
        return None
    return (first, last) if first <= last and not declares(source, first, last) else None


def branch_taken(source):
    """if (c) -> if (true)"""
    for i, token in enumerate(source.tokens):
        if token.text == "if" and (c := condition(source, i)):
            yield place(source, "branch_taken", *c, "true", f"{NUMBER} || ({source.slice(*c)})")


def branch_skipped(source):
    """if (c) and while (c) -> (false)"""
    for i, token in enumerate(source.tokens):
        if token.text in ("if", "while") and (c := condition(source, i)):
            yield place(source, "branch_skipped", *c, "false", f"!{NUMBER} && ({source.slice(*c)})")


def condition_dropped(source):
    """a && b -> b, or a; a || b likewise"""
    for i, left, right in binary(source, ("&&", "||")):
        sign = source.tokens[i].text
        for side, other in ((left, right), (right, left)):
            if side is left and source.is_(left[0] - 1, sign):
                continue  # the right side of the one before
            dropped, whole = source.slice(*side), (left[0], right[1])
            neutral = (f"({NUMBER} || ({dropped}))" if sign == "&&"
                       else f"(!{NUMBER} && ({dropped}))")
            kept = source.slice(*other)
            code = f"({neutral} {sign} {kept})" if side is left else f"({kept} {sign} {neutral})"
            yield place(source, "condition_dropped", *whole, kept, code)


def arguments(source, opening):
    """Pairs of tokens of the arguments between this parenthesis and its partner."""
    first, closing = opening + 1, source.partner[opening]
    for j in range(opening + 1, closing + 1):
        if j == closing or (source.is_(j, ",") and source.outer[j] == opening):
            if first <= j - 1:
                yield first, j - 1
            first = j + 1


VALUES = {"this", "true", "false", "nullptr"}


def form(source, first, last):
    """The shape of a plain argument, `name`, `name.name` or `name[name]`; None of any other."""
    shape = []
    for token in source.tokens[first:last + 1]:
        if token.kind == "word" and token.text not in KEYWORDS | VALUES:
            shape.append("name")
        elif token.text in (".", "->", "[", "]"):
            shape.append(token.text)
        else:
            return None
    plain = shape[:1] == ["name"] and "name name" not in " ".join(shape)
    return " ".join(shape) if plain and source.whole(first, last) else None


def declared_type(source, i):
    """The last word or `>` of the type with which name i was last declared before, as far as it is
    told by `Type name` and not by auto."""
    for j in range(i - 1, 0, -1):
        if source.tokens[j].text == source.tokens[i].text:
            before = j - 1
            while source.is_(before, "&", "*", "&&", "const") and not source.tokens[before].spaced:
                before -= 1
            type_ = source.tokens[before]
            if type_.kind == "word" and type_.text not in KEYWORDS | {"auto"}:
                return type_.text
            if source.closes(before) and type_.text == ">":
                return source.slice(source.partner[before] - 1, before)
    return None


def of_other_types(source, one, other):
    types = {declared_type(source, pair[0]) for pair in (one, other) if pair[0] == pair[1]}
    return len(types - {None}) == 2


def is_call(source, opening):
    """Whether a parenthesis opens the arguments of a call, or of a constructor's."""
    before = source.tokens[opening - 1] if opening > 0 else None
    if before is None or source.partner[opening] < 0:
        return False
    if before.text == ">" and source.closes(opening - 1):
        before = source.tokens[source.partner[opening - 1] - 1]
    return before.kind == "word" and before.text not in KEYWORDS


def arguments_swapped(source):
    """f(a, b) -> f(b, a), of neighbours of one plain form"""
    for i, token in enumerate(source.tokens):
        if token.text != "(" or not is_call(source, i) or not source.touchable(i):
            continue
        if source.tokens[i - 1].text in SYMMETRIC:
            continue
        given = list(arguments(source, i))
        for one, other in zip(given, given[1:]):
            a, b = source.slice(*one), source.slice(*other)
            alike = form(source, *one) and form(source, *one) == form(source, *other)
            if a != b and alike and not of_other_types(source, one, other):
                yield place(source, "arguments_swapped", one[0], other[1], f"{b}, {a}",
                            f"remeshd_either({NUMBER}, {a}, {b}), "
                            f"remeshd_either({NUMBER}, {b}, {a})")


def begins_statement(source, i):
    before = i - 1
    if source.is_(before, ";", "{", "}", "else", "do"):
        bracket = source.outer[i]
        return source.braces.get(bracket) == "code"
    if source.is_(before, ")"):  # of a statement's head, not of a parameter list
        opening = source.partner[before]
        return opening > 0 and source.is_(opening - 1, "if", "for", "while")
    return False


def call_left_out(source):
    """f(x); -> nothing"""
    for i, token in enumerate(source.tokens):
        if token.kind != "word" or token.text in KEYWORDS or not begins_statement(source, i):
            continue
        if not source.touchable(i):
            continue
        j, name, calls = i, None, 0
        while j < len(source.tokens):
            t = source.tokens[j]
            if t.kind == "word" and source.is_(j - 1, ".", "->", "::") or j == i:
                name = t.text
            elif t.text in (".", "->", "::"):
                pass
            elif source.opens(j) and t.text in "([<":
                calls += t.text == "("
                j = source.partner[j]
            else:
                break
            j += 1
        if source.is_(j, ";") and source.is_(j - 1, ")") and name not in ONLY_FOR_SPEED:
            yield place(source, "call_left_out", i, j, "",
                        f"{{ if (!{NUMBER}) {source.slice(i, j)} }}")


def truth_flipped(source):
    """true -> false"""
    for i, token in enumerate(source.tokens):
        if token.text in ("true", "false") and source.touchable(i):
            other = "false" if token.text == "true" else "true"
            yield place(source, "truth_flipped", i, i, other,
                        f"!{NUMBER}" if token.text == "true" else NUMBER)


EXTREMES = {"min": "max", "max": "min", "fmin": "fmax", "fmax": "fmin"}


def extreme_swapped(source):
    """std::min(a, b) -> std::max(a, b)"""
    for i, token in enumerate(source.tokens):
        if token.text not in EXTREMES or not source.is_(i - 1, "::") or not source.touchable(i):
            continue
        opening = i + 1
        if source.is_(opening, "<") and source.opens(opening):
            opening = source.partner[opening] + 1
        first = i - 2 if source.is_(i - 2, "std") else i - 4  # std:: or std::ranges::
        if not source.is_(first, "std") or not source.is_(opening, "("):
            continue
        last = source.partner[opening]
        before, rest = source.slice(first, i - 1), source.slice(i + 1, last)
        after = f"{before}{EXTREMES[token.text]}{rest}"
        yield place(source, "extreme_swapped", first, last, after,
                    f"({NUMBER} ? {after} : {before}{token.text}{rest})")


def places(source):
    return [found for operator in OPERATORS for found in operator(source)]


OPERATORS = [comparison_flipped, bound_moved, off_by_one, branch_taken, branch_skipped,
             condition_dropped, arguments_swapped, call_left_out, truth_flipped, extreme_swapped]
