#!/usr/bin/env python3
"""Manual pages of section 3 for the main calls, from their doc blocks.

    man.py VERSION FOLDER    write FOLDER/batten_curve_create.3 ... for the names in main-calls.txt
    man.py --list            these names, one a line
"""
import os
import re
import sys
import textwrap

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'tests', 'house'))
from guards import public_functions  # noqa: E402
from source import read  # noqa: E402

HERE = 'docs/reference/main-calls.txt'
HEADER_LIBRARY = {'design': 'batten-design', 'picture': 'batten-picture'}


def names():
    return [line for line in read(HERE).split('\n') if line and not line.startswith('#')]


def escaped(text):
    """Text as troff takes it: backslashes, hyphens of options and a dot in front."""
    text = text.replace('\\', '\\e').replace('-', '\\-')
    return re.sub(r"(?m)^([.'])", r'\\&\1', text)


def lines_of(block):
    inner = re.sub(r'^/\*+|\*/$', '', block.strip())
    inner = re.sub(r'(?<=[.;]) (Source: \[)', r'\n\1', inner)
    return [re.sub(r'^\s*\* ?', '', line).strip() for line in inner.split('\n')]


def declaration(header, line):
    text = read(header).split('\n', line - 1)[line - 1]
    words = ' '.join(text.split(';', 1)[0].replace('BATTEN_API', '').split()).replace('( ', '(') + ';'
    return '\n'.join(textwrap.wrap(words, 76, subsequent_indent='    '))


def paragraphs(lines):
    """The description, [(parameter, text)], the text of @return, and the other named parts."""
    about, parameters, returned, parts, into = [], [], [], [], None
    for line in lines:
        tag = re.match(r'@param(?:\[\w+\])?\s+(\w+)\s*(.*)', line)
        label = re.match(r'(Cost|Source): *(.*)', line)
        if tag:
            parameters.append((tag.group(1), [tag.group(2)]))
            into = parameters[-1][1]
        elif line.startswith('@return'):
            returned.append(line[len('@return'):].strip())
            into = returned
        elif label:
            parts.append((label.group(1), [label.group(2)]))
            into = parts[-1][1]
        elif not line:
            into = about if into is None or into is about else None
            about.append('')
        else:
            (about if into is None else into).append(line.strip())
    return '\n'.join(about).strip(), parameters, ' '.join(returned), parts


def page(row, version):
    header, line, name, _, block, _ = row
    about, parameters, returned, parts = paragraphs(lines_of(block))
    summary = re.split(r'(?<=[.;:])\s', ' '.join(about.split('\n\n')[0].split()))[0].rstrip('.;:')
    library = HEADER_LIBRARY.get(os.path.basename(header)[:-2], 'batten')
    out = [f'.TH {name} 3 "" "Batten {version}" "Batten"', '.SH NAME', f'{name} \\- {escaped(summary)}', '.SH SYNOPSIS',
           '.nf', f'#include <batten/{os.path.basename(header)}>', '', escaped(declaration(header, line)), '.fi',
           f'Link with the flags of \\fBpkg\\-config \\-\\-libs {escaped(library)}\\fP.', '.SH DESCRIPTION']
    out.append(re.sub(r'\n{2,}', '\n.PP\n', escaped(about)))
    if parameters:
        out.append('.SH PARAMETERS')
        for parameter, text in parameters:
            out += ['.TP', f'.I {parameter}', escaped(' '.join(text))]
    if returned:
        out += ['.SH RETURN VALUE', escaped(returned)]
    for label, text in parts:
        out += [f'.SH {label.upper()}', escaped(' '.join(text))]
    out += ['.SH SEE ALSO', '.BR batten (1),', '.BR batten\\-design (5)', '']
    return '\n'.join(out)


def main():
    wanted = names()
    if sys.argv[1:] == ['--list']:
        print('\n'.join(wanted))
        return 0
    version, folder = sys.argv[1:]
    rows = {row[2]: row for row in public_functions()}
    os.makedirs(folder, exist_ok=True)
    for name in wanted:
        if name not in rows:
            print(f'{HERE}: {name} is not a public function', file=sys.stderr)
            return 1
        if not rows[name][4]:
            print(f'{name} has no doc block yet, and so no page')
            continue
        with open(os.path.join(folder, name + '.3'), 'w', encoding='utf-8') as file:
            file.write(page(rows[name], version))
    return 0


if __name__ == '__main__':
    sys.exit(main())
