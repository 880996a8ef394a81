#!/bin/sh
# docs/literature.md is the index that the command makes from the table of features.
# Usage: literature.sh BATTEN SOURCE
"$1" help --as literature | diff - "$2/docs/literature.md" && exit 0
echo "docs/literature.md is not what the features say; run: batten help --as literature > docs/literature.md"
exit 1
