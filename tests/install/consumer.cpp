// A program of somebody else, in C++.
#include <batten/batten.h>
#include <batten/design.h>
#include <batten/picture.h>
#include <cstdio>

int main()
{
    batten_job job = BATTEN_JOB;
    job.thread_count = 2;
    const double points[] = {0, 0, 1, 2, 3, 3, 4, 1};
    batten_curve *curve = nullptr;
    if (batten_curve_interpolate({2, 4, points}, nullptr, nullptr, &curve) != BATTEN_OK) {
        std::puts(batten_message());
        return 1;
    }
    double u[] = {0.0, 0.5}, out[4];
    const bool good = batten_curve_evaluate_many(curve, 2, u, 0, &job, out) == BATTEN_OK;
    batten_curve_unref(curve);
    return good && out[0] == 0 ? 0 : 1;
}
