#!/bin/sh
# Same input, same bits: no library or program calls those functions of the system's mathematical library that round as
# they like. The others (sqrt, floor, remainder, ldexp ...) are exact by IEEE 754.
# Usage: libm.sh FILE...
rounded='sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10'
# fma too: that of MinGW rounds twice.
rounded="$rounded|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma|fma|remquo"
status=0
for file in "$@"; do
    for name in $(nm -u "$file" 2> /dev/null | awk '{ sub(/@.*/, "", $NF); print $NF }' | grep -xE "($rounded)[fl]?" | sort -u); do
        echo "$file calls $name of the system: use bat_$name of base/elementary.h"
        status=1
    done
done
exit $status
