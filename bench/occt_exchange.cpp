// Open CASCADE on files of patches: its readers and writers of IGES and STEP as they come.
#include "bench.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <cstdio>
#include <cstdlib>

namespace {

struct Contest {
    const bench_work *work;
    TopoDS_Shape shape;
    char path[128];
};

void must(bool good, const char *what)
{
    if (good)
        return;
    std::fprintf(stderr, "bench: occt: %s\n", what);
    std::exit(1);
}

void fill_knots(const double *knots, int count, int degree, TColStd_Array1OfReal &values,
                TColStd_Array1OfInteger &times)
{
    for (int i = 0; i < values.Length(); i++) {
        values(i + 1) = knots[degree + i];
        times(i + 1) = i == 0 || i + 1 == values.Length() ? degree + 1 : 1;
    }
    (void)count;
}

TopoDS_Shape patches(const bench_work *work)
{
    const bench_surface &s = work->surface;
    const int n = s.count, p = s.degree;
    TColStd_Array1OfReal u(1, n - p + 1), v(1, n - p + 1);
    TColStd_Array1OfInteger times(1, n - p + 1);
    fill_knots(s.knots[0], n, p, u, times);
    fill_knots(s.knots[1], n, p, v, times);
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    const double *point = s.points;
    for (size_t k = 0; k < work->count; k++) {
        TColgp_Array2OfPnt points(1, n, 1, n);
        for (int i = 1; i <= n; i++)
            for (int j = 1; j <= n; j++, point += 3)
                points(i, j) = gp_Pnt(point[0], point[1], point[2]);
        Handle(Geom_BSplineSurface) patch =
            new Geom_BSplineSurface(points, u, v, times, times, p, p);
        builder.Add(all, BRepBuilderAPI_MakeFace(patch, 1e-7).Face());
    }
    return all;
}

void *open_write(const bench_work *work)
{
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    auto *c = new Contest{work, patches(work), {}};
    bench_path(work, "occt", c->path);
    return c;
}

void run_write(void *object)
{
    auto *c = static_cast<Contest *>(object);
    if (c->work->iges) {
        IGESControl_Controller::Init();
        IGESControl_Writer writer("MM", 0);
        must(writer.AddShape(c->shape), "no IGES entities");
        writer.ComputeModel();
        must(writer.Write(c->path), "no IGES file");
    } else {
        STEPControl_Writer writer;
        Interface_Static::SetCVal("write.step.schema", "AP214IS");
        must(writer.Transfer(c->shape, STEPControl_AsIs) == IFSelect_RetDone,
             "no STEP instances");
        must(writer.Write(c->path) == IFSelect_RetDone, "no STEP file");
    }
}

void gather_write(void *object, double *result)
{
    auto *c = static_cast<Contest *>(object);
    bench_read_back(c->work, c->path, result);
}

// It reads the file that Batten wrote, or its own, whose numbers it rounded.
void *open_read(const bench_work *work)
{
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    auto *c = new Contest{work, {}, {}};
    bench_path(work, work->theirs ? "occt" : "batten", c->path);
    return c;
}

void run_read(void *object)
{
    auto *c = static_cast<Contest *>(object);
    if (c->work->iges) {
        IGESControl_Reader reader;
        must(reader.ReadFile(c->path) == IFSelect_RetDone, "no IGES file read");
        reader.TransferRoots();
        c->shape = reader.OneShape();
    } else {
        STEPControl_Reader reader;
        must(reader.ReadFile(c->path) == IFSelect_RetDone, "no STEP file read");
        reader.TransferRoots();
        c->shape = reader.OneShape();
    }
}

void gather_read(void *object, double *result)
{
    auto *c = static_cast<Contest *>(object);
    double *end = result + c->work->result_count;
    for (TopExp_Explorer at(c->shape, TopAbs_FACE); at.More() && result < end; at.Next()) {
        Handle(Geom_BSplineSurface) patch = Handle(Geom_BSplineSurface)::DownCast(
            BRep_Tool::Surface(TopoDS::Face(at.Current())));
        must(!patch.IsNull(), "a face is no B-spline");
        for (int i = 1; i <= patch->NbUPoles(); i++)
            for (int j = 1; j <= patch->NbVPoles(); j++, result += 3) {
                const gp_Pnt point = patch->Pole(i, j);
                result[0] = point.X() / 1e2;
                result[1] = point.Y() / 1e2;
                result[2] = point.Z() / 1e2;
            }
    }
    must(result == end, "faces are missing");
}

void close_contest(void *object)
{
    delete static_cast<Contest *>(object);
}

} // namespace

extern "C" const bench_entry bench_occt_exchange[] = {
    {"STEPControl, IGESControl_Writer", WRITE_PATCHES, open_write, run_write, gather_write,
     close_contest, nullptr},
    {"STEPControl, IGESControl_Reader", READ_PATCHES, open_read, run_read, gather_read,
     close_contest, nullptr},
    {},
};
