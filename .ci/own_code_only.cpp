// A check for clang-tidy that finds nothing, but lets all others look at our own declarations only.
// Nine tenths of a unit are headers of libraries: looking at them took two thirds of clang-tidy's
// time, and nobody is told what is found there. Loaded by .ci/tidy.

#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>

#include <vector>

namespace docent {
namespace {

class OwnCodeOnly : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  /// The whole unit comes before all that is in it.
  void registerMatchers(clang::ast_matchers::MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl().bind("unit"), this);
  }
  void check(const clang::ast_matchers::MatchFinder::MatchResult& found) override {
    std::vector<clang::Decl*> ours;
    for (clang::Decl* declaration : found.Context->getTranslationUnitDecl()->decls())
      if (!found.SourceManager->isInSystemHeader(declaration->getLocation()))
        ours.push_back(declaration);
    found.Context->setTraversalScope(ours);
  }
};

struct Module : clang::tidy::ClangTidyModule {
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnCodeOnly>("docent-own-code-only");
  }
};

const clang::tidy::ClangTidyModuleRegistry::Add<Module> module("docent", "Checks of our own.");

}  // namespace
}  // namespace docent
