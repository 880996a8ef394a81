#include "design/expect.h"

/* Places of surfaces moved with the least change. */

static const char sheets[] =
    "  sheet: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}\n"
    "  thick: {elevate: sheet, by: 2}\n  fine: {elevate: thick, by: 2, direction: v}\n"
    "  finer: {elevate: fine, by: 2}\n  finest: {elevate: finer, by: 2, direction: v}\n"
    "  far: {move: fine, by: [0, 0, 5]}\n  two: {collect: [fine, far]}\n"
    "  bow: {bezier: p}\n  p: {points: [[0, 0], [1, 2], [3, 0]]}\n";

static const expect_row of_places[] = {
    /* A corner of a patch is one control point. */
    {"{pull: sheet, at: [0, 0], by: [0, 0, 2]}", BATTEN_OK,
     "objects 1;named a;at 0 0 0 0 2;at 1 0 1 0 0;at 0 1 0 1 0;at 1 1 1 1 0;notes control points "
     "move by up to 2"},
    {"{pull: sheet, at: [1, 0], to: [3, 4, 12]}", BATTEN_OK,
     "at 1 0 3 4 12;at 0 0 0 0 0;at 1 1 1 1 0;notes control points move by up to 12.81"},
    /* All four points of a bilinear patch have a share of 1/4 in its middle, and move alike. */
    {"{pull: sheet, at: [0.5, 0.5], by: [0, 0, 1]}", BATTEN_OK,
     "at 0.5 0.5 0.5 0.5 1;at 0 0 0 0 1;at 1 1 1 1 1;notes control points move by up to 1"},
    {"{pull: fine, at: [[0.25, 0.5], [0.75, 0.25]], by: [[0, 0, 1], [0, 1, 2]]}", BATTEN_OK,
     "at 0.25 0.5 0.25 0.5 1;at 0.75 0.25 0.75 1.25 2"},
    {"{pull: fine, at: [[0.25, 0.5], [0.75, 0.25]], by: [0, 0, 1]}", BATTEN_OK,
     "at 0.25 0.5 0.25 0.5 1;at 0.75 0.25 0.75 0.25 1"},
    {"{pull: fine, at: [[0.25, 0.5], [0.75, 0.25]], to: [[0, 0, 1], [1, 1, 2]]}", BATTEN_OK,
     "at 0.25 0.5 0 0 1;at 0.75 0.25 1 1 2"},
    {"{pull: fine, at: [0.5, 0.5], by: [0, 0, 1], keep: edges}", BATTEN_OK,
     "at 0.5 0.5 0.5 0.5 1;at 0 0.5 0 0.5 0;at 1 0.5 1 0.5 0;at 0.5 0 0.5 0 0;at 0.5 1 0.5 1 0"},
    {"{pull: finest, at: [0.5, 0.5], by: [0, 0, 1], keep: tangent-planes}", BATTEN_OK,
     "at 0.5 0.5 0.5 0.5 1;at 0 0.5 0 0.5 0;normal 0 0.5 0 0 1;normal 0.5 1 0 0 1;normal 1 0.25 0 0 "
     "1"},
    {"{pull: two, at: [0.5, 0.5], by: [0, 0, 1]}", BATTEN_OK,
     "objects 2;at 0.5 0.5 0.5 0.5 1;object 1;at 0.5 0.5 0.5 0.5 6"},
};

TEST(places_go_where_they_are_wanted_and_as_little_else_as_can_be)
{
    EXPECT(sheets, of_places);
}

static const expect_row refused[] = {
    {"{pull: sheet, at: [0, 0]}", BATTEN_BAD_ARGUMENT, "a pull needs either 'by' or 'to'"},
    {"{pull: sheet, at: [0, 0], by: [0, 0, 1], to: [0, 0, 1]}", BATTEN_BAD_ARGUMENT,
     "a pull needs either 'by' or 'to'"},
    {"{pull: sheet, at: [[0, 0], [1, 1], [0, 1]], by: [[0, 0, 1], [0, 0, 2]]}",
     BATTEN_BAD_ARGUMENT, "'by' has 2 values for 3 places"},
    {"{pull: sheet, at: [[0, 0], [1, 1]], to: [0, 0, 1]}", BATTEN_BAD_ARGUMENT,
     "'to' has 1 value for 2 places"},
    {"{pull: sheet, at: [0, 0], to: [[0, 0, 1], [0, 0, 1]]}", BATTEN_BAD_ARGUMENT,
     "'to' has 2 values for 1 place"},
    {"{pull: sheet, at: [2, 0], to: [0, 0, 1]}", BATTEN_OUT_OF_DOMAIN, "2"},
    {"{pull: sheet, at: [2, 0], by: [0, 0, 1]}", BATTEN_OUT_OF_DOMAIN, "2"},
    {"{pull: bow, at: [0, 0], by: [0, 0, 1]}", BATTEN_BAD_ARGUMENT, "bow"},
};

TEST(pulls_without_a_place_or_a_move_are_refused)
{
    EXPECT(sheets, refused);
}
