#include "design/expect.h"

/* The output 'g-code': programs, and pictures of them. */

static const char plate[] = "  plate: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
                            "  ducks: {points: [[0, 0], [1, 2], [3, 1]]}\n"
                            "  wave: {bezier: ducks}\n";

TEST(programs_follow_their_parameters_and_pictures_show_them)
{
    static const expect_row rows[] = {
        {"p.nc: {g-code: plate, depth: -10 mm, feed: 600 mm, plunge: 90 mm, clearance: 3 mm}",
         BATTEN_OK, "G0 Z3.0000\n|G1 Z-10.0000 F90.0000\nG1 X4000.0000 Y0.0000 F600.0000\n"},
        {"p.nc: {g-code: plate, decimals: 1, moves: relative}", BATTEN_OK,
         "G91 (|G0 Z5.0\n|G1 Z-5.0 F250.0\nG1 X4000.0 Y0.0 F1000.0\nG1 X0.0 Y3000.0\n"},
        {"p.svg: {g-code: plate, depth: -10 mm, title: Plate}", BATTEN_OK, "<svg|stroke"},
        /* the height of a picture follows its shape: 4 to 3 from above, 4 to the clearance and depth from in front */
        {"p.svg: {g-code: plate}", BATTEN_OK, "height=\"9"},
        {"p.svg: {g-code: plate, view: top}", BATTEN_OK, "height=\"9"},
        {"p.svg: {g-code: plate, view: front, depth: -1}", BATTEN_OK, "height=\"4"},
        {"p.svg: {g-code: plate, width: 300, height: 200}", BATTEN_OK,
         "width=\"300|height=\"200"},
        {"p.svg: {g-code: wave}", BATTEN_UNSUPPORTED, "chains of arcs"},
        {"p.nc: {g-code: plate, title: Plate}", BATTEN_BAD_ARGUMENT,
         "'title' is for pictures of the tool's path, as .png, .svg and .pdf; 'p.nc' is a "
         "program"},
        {"p.nc: {g-code: plate, view: top}", BATTEN_BAD_ARGUMENT, "'view' is for pictures"},
        {"p.nc: {g-code: plate, width: 300}", BATTEN_BAD_ARGUMENT, "'width' is for pictures"},
        {"p.nc: {g-code: plate, height: 300}", BATTEN_BAD_ARGUMENT, "'height' is for pictures"},
    };
    EXPECT_OUTPUTS(plate, rows);
}
