#!/usr/bin/env python3
"""Writes what the viewer needs of three.js as one short script: shrink_three.py three.module.js SCRIPT MODULE.js...

Kept are the statements that define what the modules name as THREE.name, and what these name in turn; of an object or a prototype,
the members whose names occur in what is kept. This relies on the layout of three.js: a statement begins in the first column, and
a member after one tab. Comments, indentation and blanks that nothing needs are left out, also in shaders.
"""
import re
import sys

NAME = r"[A-Za-z_$][\w$]*"
TOKEN = re.compile(r"""(?s)(?P<string>'(?:\\.|[^'\\])*'|"(?:\\.|[^"\\])*"|`(?:\\.|[^`\\])*`)|(?P<blank>(?:\s|//[^\n]*|/\*.*?\*/)+)"""
                   r"""|(?P<pattern>(?<=[(=:,] )/(?:\\.|\[(?:\\.|[^\]\\])*\]|[^/\\\[])+/[gim]*)|(?P<code>[\w$]+|.)""")
MEMBERS = re.compile(rf"(?s)((?:Object\.\w+\(|var {NAME} = {{|{NAME}\.prototype = Object\.assign\()[^\n]*\n)(.*\n)(}}.*)")
MEMBER = re.compile(rf"(?m)^(?=\t(?:[gs]et )?{NAME}(?:[:,\n]| \())")
OBSOLETE = "function Face4"  # From here on, three.js has what it keeps for old programs.


class Statement:
    """A statement, or a member of an object that is kept only if something else has its name"""

    def __init__(self, text, owners, member=None):
        self.text, self.owners, self.member, self.is_kept, self.members = text, owners, member, False, []
        if member:
            text = text.replace(member, "", 1)
        self.words = set(re.findall(NAME, text))
        code = re.sub(rf"(?m)^\t+{NAME}:", "", tokens_of(text, lambda kind, token: "''" if kind == "string" else token))
        self.names = set(re.findall(rf"(?<![.\w$]){NAME}", code))

    def written(self):
        return self.text.replace("@MEMBERS@", "".join(member.text for member in self.members if member.is_kept))


def tokens_of(text, replaced):
    return TOKEN.sub(lambda token: replaced(token.lastgroup, token[0]), text)


def owners_of(text):
    """The names that a statement defines or adds a member to, and the name of this member or None"""
    if text.startswith(("var ", "let ", "const ")):
        count = 1
        while count:
            text, count = re.subn(r"[(\[{][^()\[\]{}]*[)\]}]", "", text)
        return set(re.findall(rf"(?:^\w+|,)\s*({NAME})(?=\s*[=,;])", text)), None
    owner = re.match(rf"(?:function |class |Object\.\w+\( )?((?!if\b|for\b){NAME})(?:\.prototype)?(?:\.({NAME}) = )?", text)
    return ({owner[1]}, owner[2] if owner[2] != "prototype" else None) if owner else (set(), None)


def statements_of(text):
    statements, is_obsolete = [], False
    for piece in re.split(rf"(?m)^(?={NAME})", text):
        is_obsolete = is_obsolete or piece.startswith(OBSOLETE)
        if piece.startswith("export ") or is_obsolete and not piece.startswith(("function ", "class ", "var ")):
            continue
        owners, member = owners_of(piece)
        parted = MEMBERS.fullmatch(piece)
        if not parted:
            statements.append(Statement(piece, owners, member))
            continue
        whole = Statement(parted[1] + "@MEMBERS@" + parted[3], owners)
        for text in MEMBER.split(parted[2]):
            name = re.match(rf"\t(?:[gs]et )?({NAME})", text)
            whole.members.append(Statement(text, owners, name and name[1]))
        statements += [whole, *whole.members]
    return statements


def keep_needed(statements, names, words):
    defined = set().union(*(statement.owners for statement in statements))
    count = -1
    while count != (count := sum(statement.is_kept for statement in statements)):
        for statement in statements:
            if not statement.is_kept and (not statement.owners or statement.owners & names) and (
                    not statement.member or statement.member in words):
                statement.is_kept = True
                names |= statement.names & defined
                words |= statement.words


def shortened(text):
    """The same script without comments and needless blanks"""
    pieces = [(token.lastgroup, token[0]) for token in TOKEN.finditer(text)]
    short = []
    for index, (kind, piece) in enumerate(pieces[:-1]):
        before, after = short[-1][-1] if short else ";", pieces[index + 1][1][0]
        if kind == "string":
            piece = re.sub(r"(?:\\n|\\t| |//((?!\\n).)*(?=\\n))*\\n(?:\\t| )*", r"\\n", piece)
        if kind == "blank" and (before in "{}()[];,.=?:&|<>*/+-!" or after in "{}()[];,.=?:&|<>*/+-!") and not (
                before == after and before in "+-") and not ("\n" in piece and before in ")}]" and after not in "}.,)]=?:&|"):
            piece = ""
        elif kind == "blank":
            piece = "\n" if "\n" in piece else " "
        if piece:
            short.append(piece)
    return "".join(short)


def main(three, script, *modules):
    with open(three, encoding="utf-8") as file:
        text = re.sub(r"(?ms)^\s*/\*.*?\*/\n?|^[ \t]*//[^\n]*\n", "", file.read())
    own = ""
    for module in modules:
        with open(module, encoding="utf-8") as file:
            own += tokens_of(file.read(), lambda kind, token: " " if kind == "blank" else token)
    wanted = sorted(set(re.findall(rf"\bTHREE\.({NAME})", own)))
    # Materials that are not wanted have no shaders.
    text = re.sub(rf"(?m)^\t\t({NAME}Material): '\w+',?\n", lambda line: line[0] if line[1] in wanted else "", text)
    statements = statements_of(text)
    missing = set(wanted) - set().union(*(statement.owners for statement in statements))
    if missing:
        sys.exit(f"{three} has no {', '.join(sorted(missing))}: it must be of three.js's revision 111")
    keep_needed(statements, set(wanted), set(re.findall(NAME, own)) | {"constructor"})
    own_members = {member for statement in statements for member in statement.members}
    kept = "".join(statement.written() for statement in statements if statement.is_kept and statement not in own_members)
    with open(script, "w", encoding="utf-8") as file:
        file.write(shortened(f"const THREE = (() => {{\n{kept}\nreturn {{{', '.join(wanted)}}};\n}})();\n;"))


if __name__ == "__main__":
    main(*sys.argv[1:])
