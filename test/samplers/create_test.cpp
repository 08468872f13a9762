#include <gtest/gtest.h>

#include "pbrt/samplers/samplers.h"

namespace pbrt {
namespace {

ParsedParameter Integer(std::string name, int value) {
    ParsedParameter p;
    p.type = "integer", p.name = std::move(name), p.ints = {value};
    return p;
}
ParsedParameter String(std::string name, std::string value) {
    ParsedParameter p;
    p.type = "string", p.name = std::move(name), p.strings = {std::move(value)};
    return p;
}

struct Created {
    std::optional<Sampler> sampler;
    Diagnostics log;
};

Created Create(std::string_view type, ParsedParameters params = {}, std::optional<int> spp = {},
               int seed = 0) {
    Created created;
    ParamDict dict(std::move(params), {"scene.pbrt", 3, 1}, "sampler", nullptr, &created.log);
    created.sampler = CreateSampler(dict, type, spp, seed, {64, 64});
    return created;
}

int SamplesPerPixel(const Created &c) {
    return std::visit([](const auto &s) { return s.SamplesPerPixel(); }, c.sampler.value());
}

float FirstNumber(const Created &c) {
    return std::visit(
        [](auto s) {
            s.StartPixelSample({1, 2}, 0);
            return s.Get1D();
        },
        c.sampler.value());
}

TEST(CreateSampler, PbrtsDefaults) {
    EXPECT_EQ(SamplesPerPixel(Create("independent")), 4);
    EXPECT_EQ(SamplesPerPixel(Create("stratified")), 16);
    EXPECT_EQ(SamplesPerPixel(Create("zsobol")), 16);
}

TEST(CreateSampler, CommandLineSppComesFirst) {
    EXPECT_EQ(SamplesPerPixel(Create("independent", {Integer("pixelsamples", 9)}, 7)), 7);
    EXPECT_EQ(SamplesPerPixel(Create("zsobol", {Integer("pixelsamples", 8)}, 32)), 32);
    for (int spp : {1, 7, 12, 16, 30})
        EXPECT_EQ(SamplesPerPixel(Create("stratified", {}, spp)), spp);
}

TEST(CreateSampler, SeedOfTheFileComesFirst) {
    for (const char *type : {"independent", "stratified", "zsobol"}) {
        const float def = FirstNumber(Create(type));
        EXPECT_NE(FirstNumber(Create(type, {}, {}, 5)), def);
        EXPECT_EQ(FirstNumber(Create(type, {Integer("seed", 5)})),
                  FirstNumber(Create(type, {}, {}, 5)));
        EXPECT_EQ(FirstNumber(Create(type, {Integer("seed", 0)}, {}, 5)), def);
    }
}

TEST(CreateSampler, ZSobolWarnsOfTruncation) {
    const Created created = Create("zsobol", {Integer("pixelsamples", 100)});
    EXPECT_EQ(SamplesPerPixel(created), 64);
    ASSERT_EQ(created.log.Messages().size(), 1u);
    EXPECT_EQ(created.log.Messages()[0].severity, Severity::Warning);
    EXPECT_NE(created.log.Messages()[0].text.find("64 samples per pixel instead of 100"),
              std::string::npos);
}

TEST(CreateSampler, EachRandomizationGivesOtherNumbers) {
    std::vector<float> numbers;
    for (const char *name : {"none", "permutedigits", "owen", "fastowen"}) {
        const Created created = Create("zsobol", {String("randomization", name)});
        EXPECT_FALSE(created.log.HasErrors());
        for (float other : numbers)
            EXPECT_NE(FirstNumber(created), other);
        numbers.push_back(FirstNumber(created));
    }
}

TEST(CreateSampler, UsersMistakesAreErrors) {
    const Created unknown = Create("zsobool");
    EXPECT_FALSE(unknown.sampler);
    ASSERT_TRUE(unknown.log.HasErrors());
    for (const char *part : {"scene.pbrt:3:1", "zsobool", "did you mean \"zsobol\"", "stratified"})
        EXPECT_NE(unknown.log.Messages()[0].text.find(part), std::string::npos) << part;
    EXPECT_TRUE(Create("zsobol", {Integer("pixelsamples", 0)}).log.HasErrors());
    EXPECT_TRUE(Create("zsobol", {String("randomization", "slow")}).log.HasErrors());
    EXPECT_TRUE(Create("independent", {Integer("xsamples", 4)}).log.HasErrors());
}

}  // namespace
}  // namespace pbrt
