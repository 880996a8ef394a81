#!/bin/sh
# The shared libraries export names that begin with batten_, and no others; what compilers and sanitizers
# add begins with an underscore.
# Usage: symbols.sh LIBRARY...
status=0
for library in "$@"; do
    names=$(nm -D --defined-only "$library") || exit 2
    strange=$(echo "$names" | awk '{ print $NF }' | grep -vE '^(batten_|_)')
    echo "$names" | grep -q ' batten_' || { echo "$library exports nothing"; status=1; }
    [ -z "$strange" ] || { printf '%s exports\n%s\n' "$library" "$strange"; status=1; }
done
exit $status
