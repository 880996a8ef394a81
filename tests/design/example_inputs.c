/* The files that examples of the manual read. */
#include "design/example_inputs.h"

#include "support/bodies.h"
#include "support/test.h"

#include <batten/exchange.h>

/* A small hull for the examples that read offsets.csv: half-breadths of a parabolic boat. */
static void write_offsets(const char *path)
{
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fputs("x_m,z_m,half_breadth_m\n", file);
    for (int i = 0; i <= 6; i++)
        for (int k = 0; k <= 5; k++) {
            const double x = i - 3.0, z = 0.2 * k;
            fprintf(file, "%.3f,%.3f,%.6f\n", x, z, (1.2 - x * x / 12) * sqrt(z + 0.04));
        }
    fclose(file);
}

/* A small flat-bottomed boat for the examples that read sharpie.csv: its lines are parabolas. */
static void write_sharpie(const char *path)
{
    static const char *const rows[][2] = {{"heights", "bottom"}, {"heights", "chine"},
                                          {"heights", "sheer"},  {"widths", "bottom"},
                                          {"widths", "chine"},   {"widths", "sheer"}};
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fputs("axis,name,0,1,2,3,4,5,6\nlength,station,0,1,2,3,4,5,6\n", file);
    for (int r = 0; r < 6; r++) {
        fprintf(file, "%s,%s", rows[r][0], rows[r][1]);
        for (int i = 0; i <= 6; i++) {
            const double x = i - 3.0, rise = x * x / 90, breadth = 1 - x * x / 20;
            const double values[6] = {rise, rise, 0.7 + 2 * rise, 0.02, breadth, 1.2 * breadth};
            fprintf(file, ",%.6f", values[r]);
        }
        fputs("\n", file);
    }
    fclose(file);
}

/* A solid for the examples that read block.step. */
static void write_block(const char *path)
{
    batten_model *model = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1});
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = box}));
    CHECK_OK(batten_write_file(model, path, NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(box);
}

void write_example_inputs(void)
{
    write_offsets(test_scratch("offsets.csv"));
    write_sharpie(test_scratch("sharpie.csv"));
    write_block(test_scratch("block.step"));
}
