#!/bin/sh
# Every row of the bad-input catalogue has a test whose name begins with its id.
# Usage: catalogue.sh SOURCE
cd "$1/tests" || exit 2
rows="N1 N2 N3 N4 N5 N6 N7 K1 K2 K3 K4 K5 K6 K7 K8 K9 K10 G1 G2 G3 G4 G5 G7 G8 G9 G10 S1 S2 S3 S4 S5
      F1 F2 F3 F4 F5 F6 F7 F8 P1 P2 P3 P4 P5 P6 Q1 Q2 Q3 Q4 Q5 Q6 W1 W2 W3 W4 W8 W9 U1"
missing=""
for row in $rows; do
    grep -rqE "^TEST\(${row}_" --include='*.c' . || missing="$missing $row"
done
[ -z "$missing" ] || echo "rows of the catalogue without a test:$missing"
[ -z "$missing" ]
