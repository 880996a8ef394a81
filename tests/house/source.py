"""What the scripts of this folder share: the tracked files, and C text without its comments and strings."""
import os
import re
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

TOKENS = re.compile(r"""
      (?P<comment>/\*.*?\*/|//[^\n]*)
    | (?P<string>"(?:\\.|[^"\\\n])*")
    | (?P<character>'(?:\\.|[^'\\\n])*')
    | (?P<number>(?:\.\d|\b\d)(?:[eEpP][+-]|[\w.])*)
    | (?P<name>[A-Za-z_]\w*)
    | (?P<mark>->|\+\+|--|<<=|>>=|[-+*/%&|^=!<>]=|&&|\|\||<<|>>|\.\.\.|[^\s\w])
    """, re.VERBOSE | re.DOTALL)


def tracked(*patterns):
    """The files of the repository that match, in order; those that are gone from the disk are left out."""
    names = subprocess.check_output(['git', '-C', ROOT, 'ls-files', '-z', '-c', '-o', '--exclude-standard', '--',
                                     *patterns], text=True).split('\0')
    return sorted({n for n in names if n and os.path.exists(os.path.join(ROOT, n))})


def read(path):
    with open(os.path.join(ROOT, path), encoding='utf-8', errors='replace') as file:
        return file.read()


def blanked(text, kinds=('comment', 'string', 'character')):
    """The same text with comments and the insides of strings blanked; lines and columns stay."""
    def blank(match):
        whole = match.group()
        if match.lastgroup not in kinds:
            return whole
        if match.lastgroup == 'comment':
            return re.sub(r'[^\n]', ' ', whole)
        return whole[0] + ' ' * (len(whole) - 2) + whole[-1]
    return TOKENS.sub(blank, text)


def without_directives(text):
    """Preprocessor lines blanked, with those that continue them; lines and columns stay."""
    lines, inside = text.split('\n'), False
    for i, line in enumerate(lines):
        if inside or line.lstrip().startswith('#'):
            inside = line.rstrip().endswith('\\')
            lines[i] = ' ' * len(line)
    return '\n'.join(lines)
