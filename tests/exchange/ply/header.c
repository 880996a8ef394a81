/* Headers of PLY files. */
#include "exchange/meshes/meshes.h"

TEST(F1_headers_that_are_none_are_refused_by_line)
{
    static const struct {
        const char *text, *words;
        batten_status status;
    } cases[] = {
        {"", "the file is empty", BATTEN_BAD_FORMAT},
        {"plx\n", "the first line is not 'ply'", BATTEN_BAD_FORMAT},
        {"ply\n", "t:2: the file ends within the header", BATTEN_BAD_FORMAT},
        {"ply\nend_header\n", "t:2: bad header: the format line is missing", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 2.0\n", "t:2: unknown PLY form 'ascii' 2.0", BATTEN_UNSUPPORTED},
        {"ply\nformat text 1.0\n", "unknown PLY form 'text'", BATTEN_UNSUPPORTED},
        {"ply\nformat ascii\n", "t:2: bad header: expected a format and its version",
         BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex -1\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex 1e3\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nproperty float x\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement v 1\nproperty half x\n",
         "a property needs a known type", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement v 1\nproperty list float int x\n",
         "a property needs a known type", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
         "vertices have no x, y and z", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nnonsense\n", "unknown header line", BATTEN_BAD_FORMAT},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_PLY, cases[i].status, cases[i].words);
}
