/* A surface through sections, written for other programs: a vase. */
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

enum { COUNT = 6 };

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

int main(void)
{
    static const double height[COUNT] = {0, 40, 90, 140, 180, 210};
    static const double radius[COUNT] = {45, 60, 70, 52, 30, 38};
    const double full_turn = 6.283185307179586;

    batten_curve *sections[COUNT] = {0};
    for (int i = 0; i < COUNT; i++) {
        batten_frame frame = batten_frame_world();
        frame.origin.z = height[i];
        must(batten_curve_arc_in(&frame, radius[i], 0, full_turn, &sections[i]));
    }

    batten_surface *vase = NULL;
    batten_surface_skin_report report;
    must(batten_surface_skin((batten_curve_row){COUNT, (const batten_curve *const *)sections},
                             NULL, NULL, NULL, &report, &vase));
    printf("%d x %d control points, sections off by %.2g\n",
           batten_surface_point_count(vase, BATTEN_U),
           batten_surface_point_count(vase, BATTEN_V), report.error);

    batten_model *model = NULL;
    must(batten_model_create(batten_unit_metres("mm"), &model));
    must(batten_model_add(
        model,
        &(batten_object){.name = "vase", .kind = BATTEN_OBJECT_SURFACE, .surface = vase}));
    must(batten_write_file(model, "vase.step", NULL, NULL));
    printf("wrote vase.step\n");

    batten_model_unref(model);
    batten_surface_unref(vase);
    for (int i = 0; i < COUNT; i++)
        batten_curve_unref(sections[i]);
    return 0;
}
