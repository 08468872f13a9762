#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pbrt/scene/builder.h"
#include "pbrt/scene/directives.h"
#include "pbrt/scene/parameter_reader.h"

namespace pbrt {

/// Recursive descent over the tokens of scene files; the meaning is SceneBuilder's. After a mistake
/// it goes on at the next directive, so that one run reports them all.
class Parser {
  public:
    Parser(SceneDescription *scene, Diagnostics *log);
    /// A top-level file: a path, or "-" for standard input.
    void ReadFile(const std::string &path);
    /// A top-level file's text.
    void ReadText(std::string_view text, std::string_view name, std::string_view dir);
    /// After the last file.
    void Finish();

    // What each directive reads; called through the table of directives.cpp.
    void Accelerator(), Camera(), Film(), Integrator(), PixelFilter(), Sampler();
    void ColorSpace(), Option(), Attribute(), ReverseOrientation();
    void Identity(), Translate(), Scale(), Rotate(), LookAt(), Transform(), ConcatTransform();
    void CoordinateSystem(), CoordSysTransform(), ActiveTransform(), TransformTimes();
    void WorldBegin(), AttributeBegin(), AttributeEnd(), TransformBegin(), TransformEnd();
    void ObjectBegin(), ObjectEnd(), ObjectInstance();
    void Shape(), LightSource(), AreaLightSource(), Texture();
    void Material(), MakeNamedMaterial(), NamedMaterial();
    void MakeNamedMedium(), MediumInterface();
    void Include(), Import();

  private:
    /// One file on the way from the top-level file to the current one.
    struct OpenFile {
        std::string shown,
            identity;  ///< name in messages; what tells whether two are the same file
    };

    void ReadTokens(std::string_view text, std::string_view name);
    void ReadDirective();
    void RefuseDirective(const Token &token);
    bool CheckPlace(const Directive &d);
    /// To the next directive, or the next line that begins with another name: a misspelt one.
    void Resynchronise();
    /// A file that a directive names: checked, read, parsed. False where it cannot be read.
    bool ReadNested(const std::string &name, const FileLoc &use);
    /// Counts one more; false, once with an error, where these are too many or too deep.
    bool MayInclude(const FileLoc &use);
    void ReportCycle(const OpenFile &again, const FileLoc &use);

    // Arguments. A wrong one is reported at its place, and the parser resynchronises.
    std::optional<std::string> Name(std::string_view what);
    /// A plug-in's name in quotes and its parameters.
    std::optional<Entity> NamedEntity(std::string_view what);
    Entity EntityOfType(std::string type);
    /// As many numbers as labels, which name them in messages.
    std::optional<std::vector<float>> Numbers(std::span<const std::string_view> labels);
    std::optional<Matrix4> BracketedMatrix();
    /// `describe()` says which number it is, for messages.
    template <typename Describe>
    bool NextNumber(float *value, Describe describe);
    // The value of an Option.
    void OptionFlag(bool *flag);
    void OptionInt(int *value);
    void OptionString(std::string *value);
    void OptionCoordSys();
    void SkipOptionValue();
    /// Multiplies the current transformation by `t`; `whyNot` is the error where there is none.
    void Concatenate(const std::optional<pbrt::Transform> &t, std::string_view whyNot);
    /// An error at the lexer's token: what was expected instead of it.
    void Expected(std::string_view what);
    /// An error about the directive being read.
    void Error(const FileLoc &loc, std::string_view message);

    SceneDescription *scene;
    Diagnostics *log;
    SceneBuilder builder;
    ParameterReader parameters;
    Lexer *lexer = nullptr;                ///< of the file being read
    const Directive *directive = nullptr;  ///< being read
    FileLoc at;                            ///< the directive's place
    int depth = 0;                         ///< open brackets at a failed argument
    std::string dir;                       ///< folder of the top-level file
    std::vector<OpenFile> open;
    int included = 0;          ///< files that directives named
    FileLoc worldBegin;        ///< line 0 before it
    bool allFilesRead = true;  ///< the top-level ones
    bool saidNotInWorld = false, saidTransformBegin = false;
};

}  // namespace pbrt
