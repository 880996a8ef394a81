#include "design/expect.h"
#include "design/picture_size.h"

/* The output 'cubic-plane': its axes, its title, its size and its small curves. */

static const char curves[] = "  four: {points: [[0, 0], [1, 2], [3, 2], [4, 0]]}\n"
                             "  arch: {bezier: four}\n";

TEST(the_plane_has_the_size_title_and_range_that_are_asked_for)
{
    static const expect_row rows[] = {
        {"p.svg: {cubic-plane: arch}", BATTEN_OK, "width=\"1100pt\" height=\"1200pt\""},
        {"p.svg: {cubic-plane: arch, width: 500, height: 600}", BATTEN_OK,
         "width=\"500pt\" height=\"600pt\""},
        {"p.svg: {cubic-plane: arch, from: 3, to: 1}", BATTEN_BAD_ARGUMENT,
         "the plane cannot be shown from 3 to 1"},
        {"p.eps: {cubic-plane: arch}", BATTEN_UNSUPPORTED,
         "'p.eps' must end in .png, .svg or .pdf"},
    };
    EXPECT_OUTPUTS(curves, rows);
    const size_t plain = picture_size(curves, "cubic-plane: arch");
    CHECK(plain == picture_size(curves, "cubic-plane: arch, glyphs: yes, from: -2, to: 3.6"));
    CHECK(plain > picture_size(curves, "cubic-plane: arch, glyphs: no"));
    CHECK(plain < picture_size(curves, "cubic-plane: arch, title: Arches and waves"));
    CHECK(plain != picture_size(curves, "cubic-plane: arch, to: 2"));
    CHECK(plain != picture_size(curves, "cubic-plane: arch, from: -1"));
}
