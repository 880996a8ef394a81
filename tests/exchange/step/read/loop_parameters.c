/* Curves in the parameters of a seam, in whichever order a file gives them. */
#include "exchange/reading.h"
#include "exchange/step/reading.h"

#include <batten/skin.h>
#include <batten/standard.h>

/* The tube over an ellipse from z = 0 to 3 on one that goes on to 6: a B-spline surface with a seam. */
static batten_body *tube(void)
{
    const batten_affine stretch = {{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    batten_curve *circle = NULL, *ellipse = NULL, *base = NULL;
    batten_surface *low = NULL, *high = NULL, *whole = NULL;
    batten_body *part = NULL, *body = NULL;
    CHECK_OK(batten_curve_circle(2, 0, &circle));
    CHECK_OK(batten_curve_transform(circle, &stretch, &ellipse));
    CHECK_OK(batten_curve_to_dimension(ellipse, 3, &base));
    CHECK_OK(batten_surface_extruded(base, (batten_vec3){0, 0, 3}, &low));
    CHECK_OK(batten_surface_extruded(base, (batten_vec3){0, 0, 6}, &high));
    CHECK_OK(batten_surface_set_domain(high, BATTEN_V, 0, 2, &whole));
    CHECK_OK(batten_body_from_surface("tube", low, 1e-6, &part));
    batten_body_parts parts = *batten_body_view(part);
    batten_body_face face = parts.faces[0];
    face.surface = whole;
    parts.faces = &face;
    CHECK_OK(batten_body_create(&parts, &body));
    batten_body_unref(part);
    batten_surface_unref(whole);
    batten_surface_unref(high);
    batten_surface_unref(low);
    batten_curve_unref(base);
    batten_curve_unref(ellipse);
    batten_curve_unref(circle);
    return body;
}

/* "(#12,#13)" of the seam becomes "(#13,#12)". */
static char *swapped(const char *text)
{
    char *made = test_array(strlen(text) + 1, 1), first[20], second[20];
    char *list = strchr(strstr(strcpy(made, text), "SEAM_CURVE(") + 11, '(');
    CHECK(sscanf(list, "(%19[#0-9],%19[#0-9])", first, second) == 2);
    CHECK_INT((long long)strlen(first), (long long)strlen(second));
    memcpy(list + 1, second, strlen(second));
    memcpy(list + 2 + strlen(second), first, strlen(first));
    return made;
}

/* How far the ends of the curves of a loop are apart. */
static double gap_of(const batten_body_parts *p, const batten_body_loop *loop)
{
    double worst = 0;
    for (int i = 0; i < loop->count; i++) {
        double ends[2][2];
        for (int k = 0; k < 2; k++) {
            const batten_body_use *use = &p->uses[loop->first + (i + k) % loop->count];
            CHECK(use->parameters != NULL);
            const batten_interval domain = batten_curve_domain(use->parameters);
            CHECK_OK(batten_curve_evaluate(
                use->parameters, use->reversed == (k == 1) ? domain.b : domain.a, 0, ends[k]));
        }
        worst = fmax(worst, hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]));
    }
    return worst;
}

TEST(a_loop_hangs_together_in_whichever_order_its_seam_has_its_curves)
{
    batten_body *body = tube();
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "tube", .kind = BATTEN_OBJECT_BODY, .body = body}));
    const char *text = step_text(model, NULL);
    for (int i = 0; i < 2; i++) {
        batten_model *back = read_noting(i ? swapped(text) : text, BATTEN_FORMAT_STEP, "");
        CHECK_INT(batten_model_object(back, 0)->kind, BATTEN_OBJECT_BODY);
        const batten_body_parts *p = batten_body_view(batten_model_object(back, 0)->body);
        CHECK_INT(p->loop_count, 1);
        CHECK_INT(p->loops[0].count, 4);
        CHECK(gap_of(p, &p->loops[0]) < 1e-9);
        batten_model_unref(back);
    }
    batten_model_unref(model);
    batten_body_unref(body);
}
