#!/bin/sh
# The shared libraries export names that begin with batten_, each with its version, and no others; what compilers
# and sanitizers add begins with an underscore. Static libraries keep bat_ names, but no plain ones.
# Usage: symbols.sh LIBRARY...
status=0
for library in "$@"; do
    case $library in
    *.a) names=$(nm -g --defined-only "$library" 2> /dev/null | grep ' [A-Z] ') others='^(batten_|bat_|_)' ;;
    *) names=$(nm -D --defined-only "$library" | sed 's/ A BATTEN_[0-9]*$//; /^[0-9a-f]*$/d') others='^(batten_|_)' ;;
    esac
    strange=$(echo "$names" | awk '{ print $NF }' | grep -vE "$others")
    echo "$names" | grep -q ' batten_' || { echo "$library exports nothing"; status=1; }
    [ -z "$strange" ] || { printf '%s exports\n%s\n' "$library" "$strange"; status=1; }
    case $library in
    *.so*) plain=$(echo "$names" | grep ' batten_' | grep -v '@@BATTEN_[0-9]') ;;
    *) plain= ;;
    esac
    [ -z "$plain" ] || { printf '%s exports without a version\n%s\n' "$library" "$plain"; status=1; }
done
exit $status
