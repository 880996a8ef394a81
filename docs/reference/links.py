#!/usr/bin/env python3
"""Do the links of rendered pages lead somewhere?  links.py FOLDER"""
import html
import os
import re
import sys
import urllib.parse


def main():
    folder, pages = sys.argv[1], {}
    for name in os.listdir(folder):
        if name.endswith('.html'):
            with open(os.path.join(folder, name), encoding='utf-8', errors='replace') as file:
                text = file.read()
            pages[name] = (set(re.findall(r'\b(?:id|name)="([^"]+)"', text)), re.findall(r'\b(?:href|src)="([^"]+)"', text))
    bad, count = [], 0
    for page, (_, links) in sorted(pages.items()):
        for link in set(links):
            link = urllib.parse.unquote(html.unescape(link))
            if re.match(r'[a-z]+:', link):
                continue
            count += 1
            path, _, anchor = link.partition('#')
            path = path or page
            if path in pages:
                if anchor and anchor not in pages[path][0]:
                    bad.append(f'{page}: {link}: no such place')
            elif not os.path.exists(os.path.join(folder, path)):
                bad.append(f'{page}: {link}: no such file')
    print('\n'.join(bad))
    print(f'{count} links on {len(pages)} pages, {len(bad)} lead nowhere')
    return bool(bad) or not pages


if __name__ == '__main__':
    sys.exit(main())
