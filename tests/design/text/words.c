#include "design/expect.h"

/* Values as they are written in a design: points by words, numbers with units, expressions, lists, and what is refused. */

static const char before[] = "  p: {points: [[0, 0], [4, 0], [4, 3]]}\n"
                             "  line: {line: [[0, 0], [1, 0]]}\n";

TEST(points_are_words_or_coordinates_with_units)
{
    static const expect_row rows[] = {
        {"{points: [[7, 7], x, -y, z, origin, -x, y, -z]}", BATTEN_OK,
         "count 8;data 1 1 0 0;data 2 0 -1 0;data 3 0 0 1;data 4 0 0 0;data 5 -1 0 0;data 6 0 1 0;data 7 0 0 -1"},
        {"{points: [[1 mm, 2 cm, 3 in], [-1 ft, 1e3 mm]]}", BATTEN_OK,
         "data 0 0.001 0.02 0.0762;data 1 -0.3048 1 0"},
        {"{points: [[=1+2*3, =(1+2)*3, =2^3], [=-2, =10/4, =7-2-1]]}", BATTEN_OK,
         "data 0 7 9 8;data 1 -2 2.5 4"},
        {"{points: [[=sqrt(16), =abs(-3), \"=min(2, 5)\"], [\"=max(2, 5)\", =sin(30 deg), =cos(60 deg)]]}",
         BATTEN_OK, "data 0 4 3 2;data 1 5 0.5 0.5"},
        {"{points: [[=pi, =2 m + 30 cm], [=1 m / 4, =2*(3 cm)]]}", BATTEN_OK,
         "data 0 3.141592653589793 2.3 0;data 1 0.25 0.06 0"},
        {"{points: [[1, 2, 3, 4]]}", BATTEN_BAD_FORMAT, "points"},
        {"{points: [[1]]}", BATTEN_BAD_FORMAT, "points"},
        {"{points: [[0, 0], w]}", BATTEN_BAD_FORMAT, "not 'w'"},
        {"{points: [[0, 0], xy]}", BATTEN_BAD_FORMAT, "not 'xy'"},
        {"{points: [[1 deg, 2]]}", BATTEN_BAD_FORMAT, "deg"},
        {"{points: [[1 furlnog, 2]]}", BATTEN_BAD_FORMAT, "furlnog"},
        {"{points: [[=1/0, 2]]}", BATTEN_BAD_FORMAT, ""},
        {"{points: [[=1+, 2]]}", BATTEN_BAD_FORMAT, ""},
        {"{points: [[=nothing, 2]]}", BATTEN_BAD_FORMAT, "nothing"},
        {"{points: [[=sqroot(4), 2]]}", BATTEN_BAD_FORMAT, "sqroot"},
        {"{points: [[=1 m + 1 deg, 2]]}", BATTEN_BAD_FORMAT, ""},
    };
    EXPECT(before, rows);
}

TEST(values_of_the_wrong_kind_are_refused_with_what_is_expected)
{
    static const expect_row rows[] = {
        {"{circle: 30 deg}", BATTEN_BAD_FORMAT, "circle"},
        {"{circle: [1, 2]}", BATTEN_BAD_FORMAT, "circle"},
        {"{circle: big}", BATTEN_BAD_FORMAT, "a number is expected at \"big\""},
        {"{circle: 1, form: round}", BATTEN_BAD_FORMAT, "'round'"},
        {"{circle: 1, form: squre-9}", BATTEN_BAD_FORMAT, "square-9"},
        {"{circle: 1, from: 7}", BATTEN_BAD_FORMAT, "from"},
        {"{circle: 1, fro: x}", BATTEN_BAD_FORMAT, "did you mean 'from'?"},
        {"{circle: 1, circle: 2}", BATTEN_BAD_FORMAT, "circle"},
        {"{circel: 1}", BATTEN_BAD_FORMAT, "did you mean 'circle'?"},
        {"{arc: 1, start: 90}", BATTEN_BAD_FORMAT, "start"},
        {"{arc: 1, start: 0.5 rad, angle: 1 rad}", BATTEN_OK,
         "length 1;at 0 0.8775825618903728 0.479425538604203 0"},
        {"{b-spline: p, degree: 2.5}", BATTEN_BAD_FORMAT, "a whole number is expected"},
        {"{b-spline: p, degree: =1+1}", BATTEN_OK, "degree 2"},
        {"{interpolate: p, periodic: maybe}", BATTEN_BAD_FORMAT, "maybe"},
        {"{interpolate: p, periodic: true}", BATTEN_OK, "closed 1"},
        {"{interpolate: p, periodic: yes}", BATTEN_OK, "closed 1"},
        {"{interpolate: p, periodic: no}", BATTEN_OK, "closed 0"},
        {"{interpolate: q}", BATTEN_BAD_FORMAT, "'q'"},
        {"{interpolate: lien}", BATTEN_BAD_FORMAT, "did you mean 'line'?"},
        {"{interpolate: a}", BATTEN_BAD_FORMAT, "a"},
        {"{extrude: line}", BATTEN_BAD_FORMAT, "along"},
        {"{}", BATTEN_BAD_FORMAT, "a"},
        {"[1, 2]", BATTEN_BAD_FORMAT, "a"},
        {"7", BATTEN_BAD_FORMAT, "a"},
    };
    EXPECT(before, rows);
}
