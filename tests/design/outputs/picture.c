#include "design/expect.h"

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
