#!/usr/bin/env python3
"""Numbers in texts have a decimal point, whatever the locale of the process.

    decimal_point.py    1 when a source writes a number by snprintf, which asks the locale, with the places
"""
import glob
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
CALL = re.compile(r'\bv?snprintf\((?:[^;"]|"(?:[^"\\]|\\.)*")*;')
NUMBER = re.compile(r'%[-+ #0]*(?:\*|\d+)?(?:\.(?:\*|\d+))?[lL]?[aAeEfFgG]')


def main():
    wrong = 0
    for path in sorted(glob.glob(os.path.join(ROOT, 'src', '**', '*.[ch]'), recursive=True)):
        with open(path, encoding='utf-8') as file:
            text = file.read()
        for call in CALL.finditer(text):
            if NUMBER.search(call.group(0)):
                wrong += 1
                print(f'{os.path.relpath(path, ROOT)}:{text.count(chr(10), 0, call.start()) + 1}: batten_text_print instead of snprintf')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
