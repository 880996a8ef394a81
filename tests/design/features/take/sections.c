#include "design/expect.h"

/* The feature 'sections': planes of three families through surfaces. */

static const char shapes[] =
    "  side: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 1, 1], [0, 1, 1]]}\n"
    "  back: {bilinear: [[5, 0, 0], [6, 0, 0], [6, 1, 1], [5, 1, 1]]}\n"
    "  ball: {sphere: 2}\n"
    "  one: {points: [[0, 0]]}\n";

TEST(sections_lie_in_their_planes_on_the_layers_of_their_families)
{
    static const expect_row rows[] = {
        {"{sections: side, stations: [3, 1, 1]}", BATTEN_OK,
         "objects 2;layer stations;on 1 0 0 1;length 1.4142135623730951;object 1;on 1 0 0 3;"
         "notes 2 sections, proved complete"},
        {"{sections: side, buttocks: 0.25, waterlines: [0.5], stations: 2}", BATTEN_OK,
         "objects 3;layer stations;named side station 2;on 1 0 0 2;object 1;layer buttocks;"
         "named side buttock 0.25;on 0 1 0 0.25;on 0 0 1 0.25;object 2;layer waterlines;"
         "named side waterline 0.5;on 0 0 1 0.5;length 4"},
        {"{sections: [side, back], stations: [1, 5.5]}", BATTEN_OK,
         "objects 2;notes 'side' does not meet the plane x = 5.5;"
         "notes 'back' does not meet the plane x = 1;notes 4 sections, proved complete"},
        {"{sections: side, stations: 3, flat: yes}", BATTEN_OK, "box 0 0 0 1 1 0"},
        {"{sections: side, buttocks: 0.5, flat: yes}", BATTEN_OK, "box 0 0.5 0 4 0.5 0"},
        {"{sections: side, waterlines: 0.25, flat: yes}", BATTEN_OK, "box 0 0.25 0 4 0.25 0"},
        {"{sections: side, stations: 3, as: polylines}", BATTEN_OK, "degree 1"},
    };
    EXPECT(shapes, rows);
}

TEST(what_is_not_proved_is_noted_and_what_is_nowhere_refused)
{
    static const expect_row rows[] = {
        {"{sections: ball, stations: 1, within: 1e-4}", BATTEN_OK,
         "objects 1;closed 1;within 1e-4;length 10.882796185405306;error 1e-4;"
         "notes 1 of 1 section is not proved complete, the first at x = 1 of 'ball'"},
        {"{sections: side, stations: 4}", BATTEN_OK,
         "notes 1 of 1 section is not proved complete, the first at x = 4 of 'side'"},
        {"{sections: side}", BATTEN_BAD_ARGUMENT,
         "say where 'stations', 'buttocks' or 'waterlines' are"},
        {"{sections: side, stations: [7, 9]}", BATTEN_NOT_FOUND,
         "none of the planes meets a surface"},
        {"{sections: side, stations: 2, within: 0}", BATTEN_BAD_ARGUMENT, "tolerance"},
        {"{sections: one, stations: 1}", BATTEN_BAD_ARGUMENT, "one"},
    };
    EXPECT(shapes, rows);
}
