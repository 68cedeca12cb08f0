#pragma once
/// Streaming XML with namespaces. The only place that sees the XML library. Document type
/// declarations are refused: with them go entities, and all that entities can be abused for.

#include <memory>
#include <string>
#include <string_view>

namespace spectralpack {

/// The attributes of an element. Valid during the call that hands them over.
class XmlAttributes {
  public:
    explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}

    /// Value of the attribute `name` (without namespace); null where it is missing.
    const char* find(std::string_view name) const;

    /// Value of the attribute `name` in the namespace `uri`.
    const char* find(std::string_view uri, std::string_view name) const;

  private:
    const char** pairs_;  ///< name, value, name, value, ..., null
};

struct XmlName {
    std::string_view uri, local;
};

class XmlHandler {
  public:
    virtual ~XmlHandler() = default;
    virtual void on_start(const XmlName& name, const XmlAttributes& attributes) = 0;
    virtual void on_end() = 0;
    /// A namespace prefix comes into scope; before the on_start() of the element that declares it.
    virtual void on_prefix(std::string_view prefix, std::string_view uri) = 0;
};

/// Feed it text piece by piece, then finish(). Exceptions of the handler pass through feed() and
/// finish(). Throws InputError with `file` and the entry, line and column for what is not
/// well-formed.
class XmlParser {
  public:
    XmlParser(std::string file, std::string entry, XmlHandler& handler);
    ~XmlParser();
    XmlParser(const XmlParser&) = delete;
    XmlParser& operator=(const XmlParser&) = delete;

    void feed(std::string_view text);
    void finish();

    /// For handlers: throws InputError at the place where the parser is.
    [[noreturn]] void fail(const std::string& cause) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace spectralpack
