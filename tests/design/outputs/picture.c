#include "design/expect.h"
#include "design/picture_size.h"

#include <batten/design.h>
#include <string.h>

/* Shaded pictures: each word of 'shading' has its own look, and 'auto' is one of them. */

static char *shade(const char *word, size_t *size)
{
    char text[400], *data = NULL;
    batten_design *design = NULL;
    snprintf(
        text, sizeof text,
        "batten: 1\nunits: m\nfeatures:\n  hill: {bilinear: [[0, 0, 0], [1, 0, 1], [1, 1, 0], "
        "[0, 1, 1]]}\noutputs:\n  a.png: {picture: hill, shading: %s, width: 80, height: 80}\n",
        word);
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, size));
    batten_design_free(design);
    return data;
}

TEST(each_word_of_shading_makes_its_own_picture_and_auto_that_with_isolines)
{
    static const char *const words[] = {"plain", "isolines", "zebra", "gaussian", "auto"};
    char *data[COUNT(words)];
    size_t sizes[COUNT(words)];
    for (int i = 0; i < COUNT(words); i++)
        data[i] = shade(words[i], &sizes[i]);
    for (int i = 0; i < COUNT(words); i++)
        for (int k = 0; k < i; k++) {
            const bool is_same =
                sizes[i] == sizes[k] && memcmp(data[i], data[k], sizes[i]) == 0;
            CHECK(is_same == (i == 4 && k == 1));
        }
    for (int i = 0; i < COUNT(words); i++)
        batten_release(data[i]);
}

static const char shapes[] =
    "  hill: {bilinear: [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]]}\n"
    "  net: {points: [[0, 0], [1, 2], [3, -2], [4, 0.5]]}\n  wave: {bezier: net}\n";

TEST(shading_and_line_drawings_exclude_each_other_and_need_surfaces)
{
    static const char both[] =
        "'shading' goes with none of 'hidden', 'silhouettes', 'contours', 'sheet' and "
        "'distance': these are line drawings";
    static const char needed[] =
        "'hidden', 'silhouettes', 'contours', 'sheet' and 'distance' need a surface";
    static const expect_row rows[] = {
        {"p.png: {picture: hill, shading: zebra, hidden: dashed}", BATTEN_BAD_ARGUMENT, both},
        {"p.png: {picture: hill, shading: zebra, silhouettes: yes}", BATTEN_BAD_ARGUMENT, both},
        {"p.png: {picture: hill, shading: zebra, contours: gaussian}", BATTEN_BAD_ARGUMENT,
         both},
        {"p.png: {picture: hill, shading: zebra, sheet: stereo}", BATTEN_BAD_ARGUMENT, both},
        {"p.png: {picture: hill, shading: zebra, distance: 4}", BATTEN_BAD_ARGUMENT, both},
        {"p.svg: {picture: wave, hidden: dropped}", BATTEN_BAD_ARGUMENT, needed},
        {"p.svg: {picture: wave, silhouettes: yes}", BATTEN_BAD_ARGUMENT, needed},
        {"p.svg: {picture: wave, contours: gaussian}", BATTEN_BAD_ARGUMENT, needed},
        {"p.svg: {picture: wave, sheet: three-views}", BATTEN_BAD_ARGUMENT, needed},
        {"p.svg: {picture: wave, distance: 4}", BATTEN_BAD_ARGUMENT, needed},
        {"p.svg: {picture: hill, shading: zebra}", BATTEN_UNSUPPORTED,
         "shaded pictures are written as .png, not as 'p.svg'"},
        {"p.png: {picture: wave, shading: zebra}", BATTEN_BAD_ARGUMENT,
         "'shading' needs a surface, body or mesh"},
        {"p.svg: {picture: hill, hidden: dropped, width: 300, height: 200}", BATTEN_OK,
         "width=\"300pt\" height=\"200pt\""},
        {"p.svg: {picture: hill, width: 300}", BATTEN_OK, "width=\"300pt\""},
        {"p.svg: {picture: hill}", BATTEN_OK, "width=\"1200pt\""},
    };
    EXPECT_OUTPUTS(shapes, rows);
}

TEST(each_parameter_of_a_drawing_changes_it)
{
    static const char *const curve[] = {"comb: yes", "comb: yes, comb-scale: 0.5",
                                        "polygon: yes", "title: Wave", "view: side"};
    static const char *const surface[] = {"isolines: 3",
                                          "hidden: dropped",
                                          "silhouettes: yes",
                                          "contours: gaussian",
                                          "contours: gaussian, isolines: 5",
                                          "contours: gaussian, spacing: 0.1",
                                          "sheet: three-views",
                                          "sheet: stereo",
                                          "sheet: stereo, stereo-angle: 20 deg",
                                          "distance: 3",
                                          "view: top",
                                          "azimuth: 10 deg, view: axonometric",
                                          "elevation: 10 deg, view: axonometric"};
    size_t sizes[COUNT(surface) + 1];
    char row[100];
    sizes[0] = picture_size(shapes, "picture: wave");
    for (int i = 0; i < COUNT(curve); i++) {
        snprintf(row, sizeof row, "picture: wave, %s", curve[i]);
        sizes[i + 1] = picture_size(shapes, row);
        for (int k = 0; k <= i; k++)
            CHECK(sizes[k] != sizes[i + 1]);
    }
    sizes[0] = picture_size(shapes, "picture: hill");
    for (int i = 0; i < COUNT(surface); i++) {
        snprintf(row, sizeof row, "picture: hill, %s", surface[i]);
        sizes[i + 1] = picture_size(shapes, row);
        for (int k = 0; k <= i; k++)
            CHECK(sizes[k] != sizes[i + 1]);
    }
    CHECK(picture_size(shapes, "picture: hill, contours: gaussian") ==
          picture_size(shapes, "picture: hill, contours: gaussian, isolines: 1"));
    CHECK(picture_size(shapes, "picture: hill") ==
          picture_size(shapes, "picture: hill, isolines: 10"));
}
