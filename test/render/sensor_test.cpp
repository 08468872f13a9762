// Film sensors: whose white is white, and what maxcomponentvalue limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pbrt/films/camera_matrix.h"
#include "pbrt/films/sensor.h"
#include "pbrt/scene/description.h"

namespace pbrt::test {
namespace {

Sensor Made(const std::string &parameters) {
    Diagnostics log;
    SceneDescription scene;
    ParseString("Film \"rgb\" " + parameters + " WorldBegin", "test.pbrt", "", scene, log);
    ParamDict params(scene.film.params, scene.film.loc, "film", scene.film.colorSpace, &log);
    const Sensor sensor = Sensor::Create(params, RGBColorSpace::sRGB());
    params.ReportUnused();
    EXPECT_TRUE(log.Messages().empty()) << parameters;
    return sensor;
}

/// Response to a light scaled to luminance 1, as the renderer's lights are; the mean over many
/// wavelengths.
RGB Seen(const Sensor &sensor, const Spectrum &light) {
    constexpr int kSteps = 2000;
    const Spectrum scaled = light.Scaled(1 / SpectrumToPhotometric(light));
    RGB mean;
    for (int i = 0; i < kSteps; ++i) {
        const SampledWavelengths lambda =
            SampledWavelengths::SampleVisible((float(i) + 0.5f) / kSteps);
        mean = mean + sensor.Response(scaled.Sample(lambda), lambda) * (1.f / kSteps);
    }
    return mean;
}
void ExpectWhite(const RGB &c, float tolerance, const std::string &what) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(c[i], 1, tolerance) << what << ", channel " << i;
}

/// 24 patches and 9 numbers: white comes out within 3 %.
TEST(Sensors, EveryCameraSeesItsLightAsWhite) {
    for (const CameraCurves &camera : AllCameraCurves()) {
        const std::string sensor = fmt::format("\"string sensor\" \"{}\"", camera.name);
        ExpectWhite(Seen(Made(sensor), Spectrum::Daylight(6500)), 0.03f, sensor);
        ExpectWhite(Seen(Made(sensor + " \"float whitebalance\" 5000"), Spectrum::Daylight(5000)),
                    0.03f, sensor);
        ExpectWhite(Seen(Made(sensor + " \"float whitebalance\" 3000"), Spectrum::Blackbody(3000)),
                    0.03f, sensor);
    }
}

TEST(Sensors, TheObserverAdaptsToAnyTemperature) {
    for (const int kelvin : {1000, 2000, 3000, 3999}) {
        const std::string balance = fmt::format("\"float whitebalance\" {}", kelvin);
        ExpectWhite(Seen(Made(balance), Spectrum::Blackbody(float(kelvin))), 2e-3f, balance);
    }
    for (const int kelvin : {4000, 6500, 25000}) {
        const std::string balance = fmt::format("\"float whitebalance\" {}", kelvin);
        ExpectWhite(Seen(Made(balance), Spectrum::Daylight(kelvin)), 2e-3f, balance);
    }
}

/// Curves that are sums of the observer's are fitted without error: the matrix is exact.
TEST(Sensors, ACameraThatIsAnObserverHasTheObserversColors) {
    CameraCurves camera{"observer", {}};
    for (size_t i = 0; i < camera.rgb[0].size(); ++i) {
        const float lambda = CameraCurves::kFirst + CameraCurves::kStep * float(i);
        const float x = spectra::X()(lambda), y = spectra::Y()(lambda), z = spectra::Z()(lambda);
        camera.rgb[0][i] = x + 0.2f * y;
        camera.rgb[1][i] = y;
        camera.rgb[2][i] = 0.1f * x + z;
    }
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    const Matrix3d m = XYZFromCamera(camera, space.Illuminant(), space);
    // Rows of the inverse of ((1, .2, 0), (0, 1, 0), (.1, 0, 1)); 2e-3: the camera's curves are
    // polygons of 5 nm.
    const double expected[3][3] = {{1, -0.2, 0}, {0, 1, 0}, {-0.1, 0.02, 1}};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(m[i][j], expected[i][j], 2e-3) << i << ' ' << j;
}

/// The limit is one of X, Y and Z, each of which a single sample's wavelengths make as large as the
/// light: here that of one sample is compared.
TEST(Sensors, MaxComponentValueLimitsWhatTheSensorSees) {
    const Sensor free = Made(""), limited = Made("\"float maxcomponentvalue\" 0.5");
    const RGBColorSpace &space = RGBColorSpace::sRGB();
    const Spectrum light = Spectrum::Daylight(8000).Scaled(1e-4f);
    bool some = false;
    for (int i = 0; i < 100; ++i) {
        const SampledWavelengths lambda = SampledWavelengths::SampleVisible(float(i) / 100);
        const SampledSpectrum L = light.Sample(lambda);
        const XYZ all = space.ToXYZ(free.Response(L, lambda));
        const float largest = std::max(all.X, std::max(all.Y, all.Z));
        const float scale = largest > 0.5f ? 0.5f / largest : 1;
        some |= scale < 1;
        const RGB expected = free.Response(L, lambda) * scale, got = limited.Response(L, lambda);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], expected[c], 2e-6f * (1 + std::abs(expected[c])));
    }
    EXPECT_TRUE(some);
}

TEST(Sensors, ExposureIsIsoTimesSeconds) {
    Sensor a = Made("\"float iso\" 200"),
           b = Made("\"string sensor\" \"nikon_d850\" \"float iso\" 50");
    a.SetExposure(0.25f);
    b.SetExposure(1);
    const Sensor c = Made("\"string sensor\" \"nikon_d850\"");
    const Spectrum light = Spectrum::Daylight(6500);
    ExpectWhite(Seen(a, light) * 2, 0.01f, "iso 200");
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(Seen(b, light)[i], 0.5f * Seen(c, light)[i], 1e-5f);
}

}  // namespace
}  // namespace pbrt::test
