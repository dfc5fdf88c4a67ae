"""A C++ source as tokens with matched brackets, and which of them are statements of a function.

No parser: it knows as much of the language as sources formatted by clang-format need. A binary
operator has white space on both sides; `<` without it before opens template arguments.
"""
import bisect
import re
from dataclasses import dataclass

TOKEN = re.compile(
    r"""(?P<space>\s+)
    |(?P<comment>//[^\n]*|/\*.*?\*/)
    |(?P<raw>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)")
    |(?P<string>(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")
    |(?P<char>(?:u8|[uUL])?'(?:\\.|[^'\\\n])+')
    |(?P<number>\.?\d(?:[eEpP][+-]|'?[\w.])*)
    |(?P<word>[A-Za-z_]\w*)
    |(?P<sign><=>|->\*|\.\.\.|<<=|>>=|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)""",
    re.X | re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\\n|\\.)*", re.M)

OPEN, CLOSE = "([{", ")]}"
# Their parentheses hold what the compiler evaluates or nobody runs.
UNEVALUATED = {"static_assert", "decltype", "noexcept", "sizeof", "alignof", "alignas", "assert",
               "requires", "explicit", "typeid"}
AFTER_PARAMETERS = {"const", "noexcept", "override", "final", "mutable", "try", "&"}


@dataclass(slots=True)
class Token:
    text: str
    kind: str
    begin: int  # offsets in the source
    end: int
    spaced: bool  # white space or a comment on both sides


class Source:
    """tokens; partner[i], the bracket that matches bracket i; outer[i], the innermost bracket open
    at i; -1 where there is none."""

    def __init__(self, text):
        self.text = text
        self.tokens = self._tokenise()
        self.partner = [-1] * len(self.tokens)
        self.outer = [-1] * len(self.tokens)
        self._match_angles()
        self._match_brackets()
        self.braces = {}  # index of `{` -> code, class, list or other
        for i, token in enumerate(self.tokens):
            if token.text == "{":
                self.braces[i] = self._kind_of_brace(i)
        self.untouchable = sorted(self._untouchable())
        self._line_ends = [m.start() for m in re.finditer("\n", text)]

    # Tokens.

    def _tokenise(self):
        directives = [(m.start(), m.end()) for m in DIRECTIVE.finditer(self.text)]
        tokens, at, after_space, k = [], 0, True, 0
        while at < len(self.text):
            while k < len(directives) and directives[k][1] <= at:
                k += 1
            if k < len(directives) and directives[k][0] <= at:
                at, after_space = directives[k][1], True
                continue
            m = TOKEN.match(self.text, at)
            kind, end = m.lastgroup, m.end()
            if kind == "mark":
                kind = "raw"
            if kind in ("space", "comment"):
                at, after_space = end, True
                continue
            text = m[0]
            if text == ">>" and not after_space:  # two ends of template arguments
                text, end = ">", at + 1
            following = self.text[end:end + 1]
            spaced = after_space and (following.isspace() or self.text.startswith("//", end))
            tokens.append(Token(text, kind, at, end, spaced))
            at, after_space = end, False
        return tokens

    def line(self, offset):
        return bisect.bisect_left(self._line_ends, offset) + 1

    def slice(self, first, last):
        """Text of tokens first to last, both included."""
        return self.text[self.tokens[first].begin:self.tokens[last].end]

    def is_(self, i, *texts):
        return 0 <= i < len(self.tokens) and self.tokens[i].text in texts

    # Brackets.

    def _match_angles(self):
        """Template arguments: `<` right behind a name or `template`, and the `>` that ends them."""
        t = self.tokens
        for i, token in enumerate(t):
            if token.text != "<" or token.spaced or i == 0 or self.partner[i] >= 0:
                continue
            named = t[i - 1].kind == "word" and t[i - 1].text != "operator"
            if not (named and t[i - 1].end == token.begin) and t[i - 1].text != "template":
                continue
            depth, stack = 0, []
            for j in range(i, min(i + 200, len(t))):
                text = t[j].text
                if text in OPEN:
                    stack.append(j)
                elif text in CLOSE:
                    if not stack:
                        break
                    stack.pop()
                elif stack:
                    continue
                elif text == ";":
                    break
                elif text == "<":
                    depth += 1
                elif text == ">" and not t[j].spaced or text == ">" and depth == 1:
                    depth -= 1
                    if depth == 0:
                        self.partner[i], self.partner[j] = j, i
                        break

    def _match_brackets(self):
        stack = []
        for i, token in enumerate(self.tokens):
            angle = token.text in "<>" and self.partner[i] >= 0
            if token.text in CLOSE or (angle and token.text == ">"):
                if stack:
                    self.partner[i] = stack[-1]
                    self.partner[stack.pop()] = i
            self.outer[i] = stack[-1] if stack else -1
            if token.text in OPEN or (angle and token.text == "<"):
                stack.append(i)

    def opens(self, i):
        return self.partner[i] > i

    def closes(self, i):
        return 0 <= self.partner[i] < i

    def _head(self, brace):
        """What stands before a `{` and belongs to it: indices, brackets by their closing one."""
        head, j = [], brace - 1
        while j >= 0 and self.outer[j] == self.outer[brace] and not self.is_(j, ";"):
            if self.is_(j, "}") and not self.is_(j + 1, ",", "{", ")", ".", "?", ":"):
                break  # the end of another statement
            head.append(j)
            j = (self.partner[j] if self.closes(j) else j) - 1
        return head[::-1]

    def _kind_of_brace(self, brace):
        head = self._head(brace)
        words = [self.tokens[j].text for j in head]
        parent = next((self.braces[j] for j in self.around(brace) if j in self.braces), "other")
        if not head:
            return "code" if parent == "code" else "list" if parent == "list" else "other"
        last, before = words[-1], head[-1]
        if last in ("else", "do", "try"):
            return "code"
        if words[0] in ("enum", "extern") or "namespace" in words or "concept" in words:
            return "other"
        if last == ":":  # after a case
            return parent
        parameters = ")" in words
        if any(w in ("class", "struct", "union") for w in words) and not parameters:
            return "class"
        if "enum" in words and not parameters:
            return "other"
        if last == ")":
            opening = self.partner[before]
            return "other" if self.is_(opening - 1, "requires") else "code"
        if last in AFTER_PARAMETERS and parameters:
            return "code"
        if last == "]":
            return "code" if self.is_lambda(self.partner[before]) else "list"
        if parameters and "->" in words and self.is_(head[words.index("->")] - 1, ")", "mutable",
                                                     "const", "noexcept"):
            return "code"
        if last == "}" and ":" in words and parameters:  # the last of a constructor's initialisers
            return "code"
        if "requires" in words and parameters and "=" not in words:
            return "code"
        return "list"

    def is_lambda(self, bracket):
        """Whether this `[` begins a lambda."""
        before = bracket - 1
        if before < 0 or self.tokens[before].text in ")]":
            return False
        return self.tokens[before].kind != "word" or self.is_(before, "return", "co_return")

    def around(self, i):
        """The brackets open at i, innermost first."""
        i = self.outer[i]
        while i >= 0:
            yield i
            i = self.outer[i]

    # Where a fault may be made.

    def _untouchable(self):
        """Pairs of token indices, both included."""
        for i, token in enumerate(self.tokens):
            if token.text in UNEVALUATED and self.is_(i + 1, "(") and self.partner[i + 1] > 0:
                yield i, self.partner[i + 1]
            elif token.text == "constexpr" and self.is_(i - 1, "if"):
                yield i, self.partner[i + 1]
            elif token.text in ("constexpr", "constinit", "consteval", "using", "typedef",
                                "concept"):
                end = self._end_of_declaration(i)
                if end is not None:
                    yield i, end
            elif token.text in ("case", "goto"):
                j = i
                while j < len(self.tokens) and not self.is_(j, ":", ";"):
                    j += 1
                yield i, j
            elif token.text == "[" and self.is_(i + 1, "[") and self.partner[i] > 0:
                yield i, self.partner[i]
            elif token.text == "<" and self.opens(i):
                yield i, self.partner[i]

    def _end_of_declaration(self, i):
        """Of a variable or alias; none of a function with a body, unless it is consteval."""
        immediate = self.is_(i, "consteval")
        while i < len(self.tokens) and not self.is_(i, ";"):
            if self.is_(i, "{") and self.braces[i] == "code":
                return self.partner[i] if immediate else None
            if self.closes(i):
                return i  # of what encloses the declaration
            i = self.partner[i] + 1 if self.opens(i) else i + 1
        return i

    def touchable(self, i):
        """Whether token i is run as part of a function's body."""
        k = bisect.bisect_right(self.untouchable, (i, len(self.tokens)))
        if any(first <= i <= last for first, last in self.untouchable[:k]):
            return False
        return self.function(i) is not None and not self._is_default_argument(i)

    def function(self, i):
        """The `{` of the outermost body round token i."""
        found = None
        for bracket in self.around(i):
            kind = self.braces.get(bracket)
            if kind == "code":
                found = bracket
            elif kind in ("class", "other") and found is None:
                return None
        return found

    def in_constexpr_function(self, i):
        body = self.function(i)
        return body is not None and any(self.is_(j, "constexpr") for j in self._head(body))

    def _is_default_argument(self, i):
        """Of a lambda: `=` between a comma or parenthesis and i, not in a statement's head."""
        for bracket in self.around(i):
            if bracket in self.braces:
                return False
            if not self.is_(bracket, "(") or self.is_(bracket - 1, "if", "for", "while", "switch"):
                continue
            for j in range(i - 1, bracket, -1):
                if self.outer[j] == bracket:
                    if self.is_(j, ","):
                        break
                    if self.is_(j, "="):
                        return True
        return False

    def whole(self, first, last):
        """Whether tokens first to last are balanced and no template's bracket is unmatched."""
        if first > last:
            return False
        for j in range(first, last + 1):
            if (self.opens(j) or self.closes(j)) and not first <= self.partner[j] <= last:
                return False
            lone = self.tokens[j].text in ("<", ">") and self.partner[j] < 0
            if lone and not self.tokens[j].spaced:
                return False
        return True
