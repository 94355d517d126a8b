#include "cli/command_line.h"

#include "dlfl/errors.h"
#include "ops/text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace druse {

namespace {

constexpr int largest_side = 8192;               // of a picture, pixels
constexpr long most_pixels = 32L * 1024 * 1024;
constexpr std::string_view picture_ending = ".png";

/// The words of the command line, one member for each, and the requests made of them.
class CommandLine {
public:
    CommandLine()
    {
        app_.name("druse");
        app_.set_version_flag("--version", "druse " DRUSE_VERSION);
        app_.require_subcommand(0, 1);
        app_.footer("Without a command the window opens. `druse COMMAND --help` tells more.");
        add_window();
        add_apply();
        add_info();
        add_render();
        add_ops();
    }

    Request parse(int argc, const char* const* argv)
    {
        refuse_short_with_equals({argv + 1, argv + std::max(argc, 1)});
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            return PrintRequest{app_.help()};
        } catch (const CLI::CallForVersion& version) {
            return PrintRequest{std::string(version.what()) + "\n"};
        } catch (const CLI::ExtrasError&) {
            throw CommandError(prefix() + unexpected());
        } catch (const CLI::ArgumentMismatch& e) {
            throw CommandError(prefix() + miscounted(e.what()));
        } catch (const CLI::ParseError& e) {
            throw CommandError(prefix() + e.what());
        }
        if (!app_.get_subcommands().empty() && app_.count_all() > app_.get_subcommands().front()->count_all() + 1)
            throw CommandError(fmt::format("expected everything behind '{}'", chosen().get_name()));
        try {
            return request();
        } catch (const CommandError& e) {
            throw CommandError(prefix() + e.what());
        }
    }

private:
    // --- what there is ----------------------------------------------------------------------------------------------------------

    void add_window()
    {
        app_.add_option("FILE", window_.file, "open it in the window");
        app_.add_flag("--test", window_.test, "for tests: nothing moves by itself, preferences of its own");
        app_.add_option("--geometry", window_.geometry, "size and place of the window, WxH+X+Y");
        app_.add_option("--ui-scale", ui_scale_, "size of everything in it: 1, 1.25, 1.5 or 2");
        app_.add_option("--event-log", window_.event_log, "write to this file what happens, an event a line");
        app_.add_option("--record", window_.record, "write to this file what is done with mouse and keys");
        app_.add_option("--replay", window_.replay, "do what such a file says");
    }

    void add_apply()
    {
        apply_app_ = app_.add_subcommand("apply", "edit without a window");
        apply_app_->add_option("IN", apply_.input, "the model or script (.druse) to begin with; - is standard input; none: an empty document");
        command_ = repeated(apply_app_->add_option("-c,--command", texts_[0], "run a command: NAME key=value key=value …"));
        script_ = repeated(apply_app_->add_option("-s,--script", texts_[1], "run the commands in a file"));
        output_ = repeated(apply_app_->add_option("-o,--output", texts_[2], "write what there is now; the extension says in which format"));
        apply_app_->add_option("--format", apply_.format, "the format of - : obj, stl, …");
        apply_app_->add_flag("--ascii", apply_.ascii, "write the readable variant of binary formats");
        apply_app_->footer("Commands, scripts and outputs take effect in the order given. All files appear at the end, or none.");
    }

    void add_info()
    {
        info_app_ = app_.add_subcommand("info", "print the facts of a model");
        info_app_->add_option("FILE", info_.input, "the model or script; - is standard input")->required();
        info_app_->add_option("--format", info_.format, "the format of -");
        info_app_->add_flag("--json", info_.json, "as one JSON object");
        info_app_->add_flag("--check", info_.check, "look for self-intersections too, which may take a while");
    }

    void add_render()
    {
        render_app_ = app_.add_subcommand("render", "draw a picture of a model");
        render_app_->add_option("FILE", render_.input, "the model or script; - is standard input")->required();
        render_app_->add_option("-o,--output", render_.output, "the picture, a .png file; - is standard output")->required();
        render_app_->add_option("--format", render_.format, "the format of the model from -");
        render_app_->add_option("--size", size_, "in pixels, WxH")->capture_default_str();
        CLI::Option* const flat = render_app_->add_flag("--flat", render_.flat, "show the flat tiling of a layered tile, as its .svg does");
        render_app_->add_option("--view", view_, "iso, front, back, left, right, top, bottom or AZ,EL in degrees")->capture_default_str();
        render_app_->add_flag("--parallel", render_.options.parallel, "without perspective");
        render_app_->add_option("--shading", shading_, "flat or smooth")->capture_default_str();
        render_app_->add_flag("--smooth", render_.smooth, "show the surface that Catmull-Clark subdivision goes to, as the window's smooth preview does");
        render_app_->add_flag("--edges", render_.options.edges, "draw the edges");
        render_app_->add_flag("--groups", render_.options.groups, "show face groups in their colours");
        render_app_->add_flag("--transparent", render_.options.transparent, "no background");
        render_app_->add_option("--background", background_, "one colour, #rrggbb");
        for (const char* other : {"--view", "--parallel", "--shading", "--smooth", "--edges", "--groups", "--transparent"}) flat->excludes(other);
    }

    void add_ops()
    {
        ops_app_ = app_.add_subcommand("ops", "list the operators and their parameters");
        ops_app_->add_option("NAME", ops_.name, "only this one");
        ops_app_->add_flag("--json", ops_json_, "as JSON");
        ops_app_->add_flag("--markdown", ops_markdown_, "as the reference page");
    }

    static CLI::Option* repeated(CLI::Option* option) { return option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll); }

    // --- what was asked for -------------------------------------------------------------------------------------------------------

    Request request()
    {
        if (apply_app_->parsed()) return apply();
        if (info_app_->parsed()) {
            check_format(info_.format, info_.input == "-");
            return std::move(info_);
        }
        if (render_app_->parsed()) return render();
        if (ops_app_->parsed()) {
            if (ops_json_ && ops_markdown_) throw CommandError("--json and --markdown: expected one of the two");
            if (ops_json_) ops_.form = OpsRequest::Form::json;
            if (ops_markdown_) ops_.form = OpsRequest::Form::markdown;
            return std::move(ops_);
        }
        window_.ui_scale = one_of<double>("--ui-scale", ui_scale_, {{"", 0.0}, {"1", 1.0}, {"1.25", 1.25}, {"1.5", 1.5}, {"2", 2.0}});
        return std::move(window_);
    }

    ApplyRequest apply()
    {
        using Kind = ApplyRequest::Step::Kind;
        const std::map<const CLI::Option*, std::pair<Kind, std::size_t>> kinds{
            {command_, {Kind::command, 0}}, {script_, {Kind::script, 1}}, {output_, {Kind::output, 2}}};
        std::size_t next[3] = {};
        for (const CLI::Option* option : apply_app_->parse_order())
            if (const auto it = kinds.find(option); it != kinds.end()) {
                const auto [kind, list] = it->second;
                apply_.steps.push_back({kind, texts_[list].at(next[list]++)});
            }
        if (!apply_.input && apply_.steps.empty()) throw CommandError("expected a file, -c COMMAND, -s SCRIPT or -o OUT");
        check_format(apply_.format, apply_.input == "-" || std::ranges::find(texts_[kinds.at(output_).second], "-") != texts_[kinds.at(output_).second].end());
        return std::move(apply_);
    }

    RenderRequest render()
    {
        StillOptions& options = render_.options;
        const auto pieces = split(size_, 'x');
        long long width = 0, height = 0;
        try {
            if (pieces.size() == 2) width = parse_integer(pieces[0]), height = parse_integer(pieces[1]);
        } catch (const CommandError&) {
        }
        if (width < 1 || height < 1 || width > largest_side || height > largest_side || width * height > most_pixels)
            throw CommandError(fmt::format("--size {}: expected WxH, 1 to {} pixels each and at most {} in all", size_, largest_side, most_pixels));
        options.width = static_cast<int>(width);
        options.height = static_cast<int>(height);

        const auto view = view_from_text(view_);
        if (!view) throw CommandError(fmt::format("--view {}: expected iso, front, back, left, right, top, bottom or AZ,EL with EL from -90 to 90", view_));
        options.view = *view;

        options.shading = one_of<Style::Shading>("--shading", shading_, {{"flat", Style::Shading::flat}, {"smooth", Style::Shading::smooth}});
        if (!background_.empty()) {
            if (options.transparent) throw CommandError("--transparent and --background: expected one of the two");
            options.background = colour_from_hex(background_);
            if (!options.background) throw CommandError(fmt::format("--background {}: expected a colour #rrggbb", background_));
        }
        check_format(render_.format, render_.input == "-");
        const std::string ending = render_.output.substr(render_.output.size() - std::min(render_.output.size(), picture_ending.size()));
        if (render_.output != "-" && CLI::detail::to_lower(ending) != picture_ending)
            throw CommandError(fmt::format("-o {}: expected a name that ends in {}", render_.output, picture_ending));
        return std::move(render_);
    }

    template <class T>
    static T one_of(std::string_view option, const std::string& given, std::initializer_list<std::pair<const char*, T>> choices)
    {
        std::vector<std::string> names;
        for (const auto& [name, value] : choices) {
            if (name == given) return value;
            if (*name) names.emplace_back(name);
        }
        throw CommandError(fmt::format("{} {}: expected {}", option, given, listing(names)));
    }

    static void check_format(const std::string& format, bool has_stream)
    {
        if (!format.empty() && !has_stream) throw CommandError(fmt::format("--format {}: goes with -, but no standard stream is read or written", format));
    }

    // --- what was wrong -----------------------------------------------------------------------------------------------------------

    CLI::App& chosen() { return app_.get_subcommands().empty() ? app_ : *app_.get_subcommands().front(); }

    /// CLI11 takes `-o=x` for the value `=x`.
    static void refuse_short_with_equals(std::span<const char* const> arguments)
    {
        for (const std::string_view a : arguments)
            if (a.size() > 2 && a[0] == '-' && a[1] >= 'a' && a[1] <= 'z' && a[2] == '=')
                throw CommandError(fmt::format("'{}': expected '{} {}'", a, a.substr(0, 2), a.substr(3)));
    }

    /// `complaint` begins with the name of an option that has too few values or too many.
    std::string miscounted(const std::string& complaint)
    {
        const std::string name = complaint.substr(0, complaint.find(':'));
        const CLI::Option* option = chosen().get_option_no_throw(name);
        return option && option->count() > 1 ? name + " is given more than once" : name + " needs a value";
    }

    std::string prefix() { return app_.get_subcommands().empty() ? std::string() : chosen().get_name() + ": "; }

    std::string unexpected()
    {
        const std::string word = app_.remaining(true).front();
        if (app_.get_subcommands().empty() && !window_.file.empty() && !word.starts_with('-')) return unknown_command();
        if (!word.starts_with('-')) return fmt::format("'{}' is one argument too many", word);
        std::vector<std::string> names;
        for (const CLI::Option* option : chosen().get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        const std::string best = nearest(word, names);
        return best.empty() ? fmt::format("unknown option '{}'", word) : fmt::format("unknown option '{}'; did you mean '{}'?", word, best);
    }

    /// The window opens one file, so two words are most likely a command that there is not.
    std::string unknown_command() const
    {
        std::vector<std::string> names;
        for (const CLI::App* command : {apply_app_, info_app_, render_app_, ops_app_}) names.push_back(command->get_name());
        const std::string best = nearest(window_.file, names);
        return best.empty() ? fmt::format("unknown command '{}'; expected {}", window_.file, listing(names))
                            : fmt::format("unknown command '{}'; did you mean '{}'?", window_.file, best);
    }

    CLI::App app_{"Druse models crystal-like shapes from meshes."};
    CLI::App *apply_app_ = nullptr, *info_app_ = nullptr, *render_app_ = nullptr, *ops_app_ = nullptr;
    CLI::Option *command_ = nullptr, *script_ = nullptr, *output_ = nullptr;

    WindowRequest window_;
    ApplyRequest apply_;
    std::vector<std::string> texts_[3]; // of -c, -s and -o
    InfoRequest info_;
    RenderRequest render_;
    std::string size_ = "1280x800", view_ = "iso", shading_ = "flat", background_, ui_scale_;
    OpsRequest ops_;
    bool ops_json_ = false, ops_markdown_ = false;
};

} // namespace

Request parse_arguments(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

} // namespace druse
