#!/bin/sh
# The tables of the elementary functions are what their script makes.
# Usage: tables.sh SOURCE PYTHON
made=$(mktemp -d) || exit 2
trap 'rm -rf "$made"' EXIT
"$2" "$1/src/base/elementary/make_tables.py" "$made" || exit 1
status=0
for file in "$made"/*; do
    cmp "$file" "$1/src/base/elementary/$(basename "$file")" || status=1
done
exit $status
