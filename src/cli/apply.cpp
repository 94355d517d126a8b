#include "app/registry.h"
#include "app/save.h"
#include "app/script.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "dlfl/errors.h"
#include "io/output.h"

#include <iterator>
#include <utility>

namespace druse {

namespace {

/// Prints what queries found and keeps the notes until the run has succeeded.
class Sayings {
public:
    void take(Document::Outcome&& outcome)
    {
        if (!outcome.output.empty()) print(outcome.output + "\n");
        if (outcome.failed) throw CommandError(outcome.failure);
        std::move(outcome.notes.begin(), outcome.notes.end(), std::back_inserter(notes_));
    }
    const std::vector<std::string>& notes() const { return notes_; }

private:
    std::vector<std::string> notes_;
};

} // namespace

void apply(const ApplyRequest& request, Progress& progress)
{
    Document document(all_operators());
    OutputSet output;
    Sayings sayings;
    if (request.input) sayings.take(open_input(document, *request.input, request.format, progress));
    for (const ApplyRequest::Step& step : request.steps) {
        using Kind = ApplyRequest::Step::Kind;
        if (step.kind == Kind::command) sayings.take(document.apply(step.text, progress));
        else if (step.kind == Kind::script) sayings.take(document.run(Script::read(step.text), progress));
        else write_document(document, output, step.text, {step.text == "-" ? request.format : "", request.ascii});
    }
    progress.step(1.0);
    output.commit();
    print_notes(sayings.notes());
    print_notes(output.notes());
}

} // namespace druse
