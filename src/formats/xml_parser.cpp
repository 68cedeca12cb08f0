#include "formats/xml_parser.hpp"

#include <expat.h>

#include <exception>
#include <new>
#include <utility>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

constexpr char kSeparator = '\x01';  // between namespace and name; XML can hold no such character

XmlName split(std::string_view name) {
    const std::size_t at = name.rfind(kSeparator);
    if (at == std::string_view::npos) return {{}, name};
    return {name.substr(0, at), name.substr(at + 1)};
}

}  // namespace

const char* XmlAttributes::find(std::string_view name) const {
    for (const char** pair = pairs_; *pair; pair += 2) {
        if (name == *pair) return pair[1];
    }
    return nullptr;
}

const char* XmlAttributes::find(std::string_view uri, std::string_view name) const {
    for (const char** pair = pairs_; *pair; pair += 2) {
        const XmlName found = split(*pair);
        if (found.local == name && found.uri == uri) return pair[1];
    }
    return nullptr;
}

struct XmlParser::State {
    std::string file, entry;
    XmlHandler& handler;
    XML_Parser parser;
    std::exception_ptr thrown;  ///< by the handler; must not travel through the library's own frames

    State(std::string file_name, std::string entry_name, XmlHandler& events)
        : file(std::move(file_name)),
          entry(std::move(entry_name)),
          handler(events),
          parser(XML_ParserCreateNS(nullptr, kSeparator)) {
        if (!parser) throw std::bad_alloc();
    }
    ~State() { XML_ParserFree(parser); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    template <class Action>
    void guarded(Action action) {
        if (thrown) return;
        try {
            action();
        } catch (...) {
            thrown = std::current_exception();
            XML_StopParser(parser, XML_FALSE);
        }
    }

    [[noreturn]] void fail(const std::string& cause) const {
        throw InputError(file,
                         entry + " line " + std::to_string(XML_GetCurrentLineNumber(parser)) + " column " +
                             std::to_string(XML_GetCurrentColumnNumber(parser) + 1),
                         cause);
    }

    static void on_start(void* user, const XML_Char* name, const XML_Char** attributes) {
        auto* state = static_cast<State*>(user);
        state->guarded([&] { state->handler.on_start(split(name), XmlAttributes(attributes)); });
    }
    static void on_end(void* user, const XML_Char*) {
        auto* state = static_cast<State*>(user);
        state->guarded([&] { state->handler.on_end(); });
    }
    static void on_namespace(void* user, const XML_Char* prefix, const XML_Char* uri) {
        auto* state = static_cast<State*>(user);
        state->guarded([&] { state->handler.on_prefix(prefix ? prefix : "", uri ? uri : ""); });
    }
    static void on_doctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
        auto* state = static_cast<State*>(user);
        state->guarded([&] { state->fail("a document type declaration is not allowed"); });
    }

    void parse(std::string_view text, bool last) {
        const XML_Status status = XML_Parse(parser, text.data(), static_cast<int>(text.size()), last ? 1 : 0);
        if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
        if (status != XML_STATUS_OK) {
            fail(std::string("is not well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(parser)));
        }
    }
};

XmlParser::XmlParser(std::string file, std::string entry, XmlHandler& handler)
    : state_(std::make_unique<State>(std::move(file), std::move(entry), handler)) {
    XML_SetUserData(state_->parser, state_.get());
    XML_SetElementHandler(state_->parser, State::on_start, State::on_end);
    XML_SetStartNamespaceDeclHandler(state_->parser, State::on_namespace);
    XML_SetStartDoctypeDeclHandler(state_->parser, State::on_doctype);
}

XmlParser::~XmlParser() = default;

void XmlParser::feed(std::string_view text) {
    constexpr std::size_t kPiece = 1 << 20;  // the library counts in int
    for (; !text.empty(); text.remove_prefix(std::min(kPiece, text.size()))) {
        state_->parse(text.substr(0, kPiece), false);
    }
}

void XmlParser::finish() { state_->parse({}, true); }

void XmlParser::fail(const std::string& cause) const { state_->fail(cause); }

}  // namespace spectralpack
