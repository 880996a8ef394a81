#include "cli/lines.h"

/* What a build makes, reports and refuses. */

TEST(build_says_what_it_made_and_keeps_what_could_be_made)
{
    static const line_row rows[] = {
        {"$BATTEN build all.yaml && ls", 0,
         "one            line|bow            interpolate|wrote one.igs\nwrote all.step\nwrote "
         "sheet.step\nwrote report.txt|all.step",
         ""},
        {"$BATTEN build -q all.yaml && ls", 0, "!wrote|all.step\nall.yaml", ""},
        {"$BATTEN build --json all.yaml", 0,
         "{\"features\": [\n    {\"name\": \"one\", \"operation\": \"line\", \"status\": \"OK\", \"seconds\": |},\n    "
         "{\"name\": \"ring\"|],\n  \"outputs\": [\"one.igs\", \"all.step\", \"sheet.step\", \"report.txt\", "
         "\"report.json\"],\n  \"messages\": []}\n",
         ""},
        {"rm -f *.igs *.step && $BATTEN build all.yaml --only bow && ls", 0,
         "ducks |bow |!one |!wrote|!all.step", ""},
        {"$BATTEN build all.yaml -q -o made && ls made", 0, "all.step\none.igs\nreport.json",
         ""},
        {"$BATTEN build all.yaml -q -o all.yaml", 1, NULL,
         "'all.yaml' should be the folder of the outputs, but is a file"},
        {"$BATTEN build all.yaml -q --set long=5 && $BATTEN eval one.igs --at 1", 0, "=5 0 0\n",
         NULL},
        {"$BATTEN build all.yaml -q --set features.ring.circle=3 && $BATTEN eval all.step#ring --at 0",
         0, "=3 0 0\n", NULL},
        {"$BATTEN build all.yaml -q --set features.ring.circle=3 --set long=7 && $BATTEN eval one.igs --at 1",
         0, "=7 0 0\n", NULL},
        {"$BATTEN build all.yaml -q --set parameters.long=6 && $BATTEN eval one.igs --at 1", 0,
         "=6 0 0\n", NULL},
        {"$BATTEN build all.yaml --set lnog=5", 2, NULL,
         "--set: the design has no parameter 'lnog'; did you mean 'long'?"},
        {"$BATTEN build all.yaml --set =5", 2, NULL, "--set wants NAME=VALUE, not '=5'"},
        {"$BATTEN build all.yaml --set long", 2, NULL, "--set wants NAME=VALUE, not 'long'"},
        {"$BATTEN build all.yaml --only nothing", 2, NULL, "nothing"},
        {"sed 's/circle: 2/circle: 0/' all.yaml > bad.yaml; rm -f *.step; $BATTEN build bad.yaml",
         1, NULL, "ring (circle): |batten build: failed; 4 of 5 outputs were made"},
        {"sed 's/circle: 2/circle: 0/' all.yaml > bad.yaml; rm -f *.step; $BATTEN build bad.yaml; ls",
         0, "ring           circle       failed|sheet.step|!all.step", NULL},
        {"sed 's/check: bow/check: bow, curvatrue: 0.001/' all.yaml > bad.yaml; $BATTEN build -q bad.yaml",
         1, NULL, NULL},
        {"$BATTEN build none.yaml", 1, "", "batten build: |none.yaml"},
        {"cp all.yaml one.igs && $BATTEN build one.igs", 2, NULL, "one.igs"},
        {"printf '0 0\\n1 1\\n2 0\\n3 1\\n' > d.xyz; printf 'batten: 1\\nfeatures:\\n  p: {read: d.xyz}\\noutputs:\\n  "
         "d.xyz: p\\n' > own.yaml; $BATTEN build own.yaml; cat d.xyz",
         0, "=0 0\n1 1\n2 0\n3 1\n", "d.xyz"},
        {"printf 'batten: 1\\nfeatures:\\n  p: {points: [[0, 0], [1, 0], [2, 0.1], [3, 0], [4, 0], [5, 0]]}\\n  f: {fair: p, "
         "within: 0.2}\\noutputs: {f.csv: f}\\n' > f.yaml; $BATTEN build f.yaml; $BATTEN build --json f.yaml",
         0,
         "points moved, at most 0.|, excess inflections 3 -> 0|\"moved\": {\"max\": 0.|\"count\": |\"excess_inflections\": "
         "{\"before\": 3, \"after\": 0}",
         NULL},
    };
    RUN_LINES(rows);
}
