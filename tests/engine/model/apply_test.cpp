#include <gtest/gtest.h>

#include "engine/model/feature_model.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using test::point;
using Profile = std::vector<ProfileEntry>;

const Profile kTriangle{point(0.0, 0.0), point(5.0, 0.0), point(0.0, 5.0)};

ModelSource base_rib_and_ring() {
  ModelSource model =
      test::one_feature(test::feature("base", "block", {{"dx", "w"}, {"dy", 40.0}, {"dz", 10.0}}));
  model.parameters = {{"w", 80.0}};
  model.features.push_back(test::feature("rib", "prism", kTriangle, {{"height", 3.0}}));
  model.features.push_back(
      test::feature("ring", "revolution", {point(1.0, 0.0), point(2.0, 0.0), point(1.0, 2.0)}, {}));
  return model;
}

std::vector<std::string> ids(const ModelSource& model) {
  std::vector<std::string> result;
  for (const FeatureSource& f : model.features) result.push_back(f.id);
  return result;
}

ModelSource edited(std::vector<Edit> edits) {
  return apply(base_rib_and_ring(), {std::move(edits)});
}

/// `index reason feature parameter` of the error; a sound edit goes before the one given.
std::string edit_failure(const Edit& edit) {
  const ErrorInfo info = test::error_of([&] {
    edited({SetParameter{"w", 90.0}, edit, SetParameter{"nope", 1.0}});
  });
  EXPECT_EQ(info.stage, "model");
  EXPECT_FALSE(info.hint.empty() && info.reason != "WRONG_VALUE_KIND");
  return (info.edit_index ? std::to_string(*info.edit_index) : "none") + " " + test::place_of(info);
}

TEST(Apply, LeavesItsArgumentAsItWas) {
  const ModelSource before = base_rib_and_ring();
  const ModelSource after = apply(before, {{RemoveFeature{"rib"}, SetParameter{"w", 1.0}}});
  EXPECT_EQ(before, base_rib_and_ring());
  EXPECT_NE(after, before);
  EXPECT_EQ(apply(before, {}), before);
}

TEST(Apply, SetParameterTakesANumberOrAnExpression) {
  EXPECT_EQ(edited({SetParameter{"w", 85.0}}).parameters[0].value, Scalar(85.0));
  EXPECT_EQ(edited({SetParameter{"w", "8*10"}}).parameters[0].value, Scalar("8*10"));
}

TEST(Apply, SetFeatureParameterReplacesOneValueOrTheProfile) {
  const ModelSource model = edited({SetFeatureParameter{"base", "dx", Scalar("w/2")},
                                    SetFeatureParameter{"ring", "profile", kTriangle}});
  EXPECT_EQ(model.features[0].parameters.at("dx"), Scalar("w/2"));
  EXPECT_EQ(model.features[0].parameters.at("dy"), Scalar(40.0));
  EXPECT_EQ(model.features[2].profile, kTriangle);
}

TEST(Apply, AParameterWithADefaultMayBeSetThoughItWasNotWritten) {
  EXPECT_EQ(edited({SetFeatureParameter{"ring", "angle", Scalar(90.0)}})
                .features[2]
                .parameters.at("angle"),
            Scalar(90.0));
}

TEST(Apply, SetPlacementReplacesTheWholePlacement) {
  const PlacementSource first{{1.0, 2.0, 3.0}, std::array<Scalar, 3>{0.0, 1.0, 0.0}, {}};
  const PlacementSource second{{"w", 0.0, 0.0}, {}, {}};
  EXPECT_EQ(edited({SetPlacement{"rib", first}}).features[1].placement, first);
  EXPECT_EQ(edited({SetPlacement{"rib", first}, SetPlacement{"rib", second}}).features[1].placement,
            second);
}

TEST(Apply, AddFeatureGoesToTheEndOrAfterAnother) {
  const FeatureSource pin = test::feature("pin", "sphere", {{"radius", 1.0}});
  EXPECT_EQ(ids(edited({AddFeature{pin, ""}})),
            (std::vector<std::string>{"base", "rib", "ring", "pin"}));
  EXPECT_EQ(ids(edited({AddFeature{pin, "base"}})),
            (std::vector<std::string>{"base", "pin", "rib", "ring"}));
  EXPECT_EQ(ids(edited({AddFeature{pin, "ring"}})),
            (std::vector<std::string>{"base", "rib", "ring", "pin"}));
  EXPECT_EQ(edited({AddFeature{pin, ""}}).features.back(), pin);
}

TEST(Apply, EditsRunInOrder) {
  const FeatureSource block =
      test::feature("rib", "block", {{"dx", 1.0}, {"dy", 1.0}, {"dz", 1.0}});
  const ModelSource model = edited({RemoveFeature{"rib"}, AddFeature{block, "base"},
                                    SetFeatureParameter{"rib", "dz", Scalar(7.0)}});
  EXPECT_EQ(ids(model), (std::vector<std::string>{"base", "rib", "ring"}));
  EXPECT_EQ(model.features[1].parameters.at("dz"), Scalar(7.0));
}

TEST(Apply, RemoveFeatureTakesItOut) {
  EXPECT_EQ(ids(edited({RemoveFeature{"rib"}})), (std::vector<std::string>{"base", "ring"}));
}

TEST(Apply, ResultIsNotYetValidated) {
  EXPECT_NO_THROW(edited({RemoveFeature{"rib"}, RemoveFeature{"ring"}, RemoveFeature{"base"}}));
  EXPECT_NO_THROW(edited({SetFeatureParameter{"base", "dx", Scalar(-1.0)}}));
}

TEST(EvaluateEdited, AnErrorOfTheResultNamesTheEditWithWhichItCame) {
  const auto failure = [](std::vector<Edit> edits) {
    const ErrorInfo info =
        test::error_of([&] { evaluate_edited(base_rib_and_ring(), {std::move(edits)}); });
    return (info.edit_index ? std::to_string(*info.edit_index) : "none") + " " +
           test::place_of(info);
  };
  const SetParameter sound{"w", 90.0};
  const SetFeatureParameter flat{"base", "dx", Scalar(-1.0)};
  EXPECT_EQ(failure({sound, flat, sound}), "1 DEGENERATE_FEATURE base dx");
  EXPECT_EQ(failure({flat, SetFeatureParameter{"base", "dx", Scalar(1.0)}, sound, flat}),
            "3 DEGENERATE_FEATURE base dx");
  // By way of a parameter of the model.
  EXPECT_EQ(failure({SetFeatureParameter{"base", "dx", "w"}, sound, SetParameter{"w", -1.0}}),
            "2 DEGENERATE_FEATURE base dx");
  EXPECT_EQ(failure({RemoveFeature{"rib"}, RemoveFeature{"base"}, RemoveFeature{"ring"}}),
            "2 NO_FEATURES - -");
  EXPECT_EQ(failure({sound, SetGroup{"load", "rib.top &", {}}}),
            "1 SELECTOR_INVALID - groups.load.on");
}

TEST(EvaluateEdited, NoEditIsAtFaultForWhatWasWrongBefore) {
  ModelSource wrong = base_rib_and_ring();
  wrong.features[0].parameters["dx"] = -1.0;
  const ErrorInfo info = test::error_of([&] {
    evaluate_edited(wrong, {{SetParameter{"w", 90.0}}});
  });
  EXPECT_EQ(test::place_of(info), "DEGENERATE_FEATURE base dx");
  EXPECT_FALSE(info.edit_index);
}

TEST(EvaluateEdited, GivesTheDocumentAndItsModel) {
  const ModelEdit edit{{SetParameter{"w", 90.0}}};
  const EvaluatedModel made = evaluate_edited(base_rib_and_ring(), edit);
  EXPECT_EQ(made.source, apply(base_rib_and_ring(), edit));
  EXPECT_TRUE(same_geometry(made.model, evaluate(made.source)));
}

TEST(Apply, UnknownNamesAreErrorsWithTheIndexOfTheEdit) {
  const FeatureSource pin = test::feature("pin", "sphere", {{"radius", 1.0}});
  EXPECT_EQ(edit_failure(SetParameter{"W", 1.0}), "1 UNKNOWN_PARAMETER - W");
  EXPECT_EQ(edit_failure(SetFeatureParameter{"Base", "dx", Scalar(1.0)}),
            "1 UNKNOWN_FEATURE Base -");
  EXPECT_EQ(edit_failure(SetFeatureParameter{"base", "radius", Scalar(1.0)}),
            "1 UNKNOWN_PARAMETER base radius");
  EXPECT_EQ(edit_failure(SetFeatureParameter{"base", "profile", kTriangle}),
            "1 UNKNOWN_PARAMETER base profile");
  EXPECT_EQ(edit_failure(SetPlacement{"nut", {}}), "1 UNKNOWN_FEATURE nut -");
  EXPECT_EQ(edit_failure(AddFeature{pin, "nut"}), "1 UNKNOWN_FEATURE nut -");
  EXPECT_EQ(edit_failure(RemoveFeature{"nut"}), "1 UNKNOWN_FEATURE nut -");
  EXPECT_EQ(edit_failure(RemoveFeature{""}), "1 UNKNOWN_FEATURE - -");
}

TEST(Apply, ANameThatIsNearlyRightIsAnsweredWithTheOneThatMayBeMeant) {
  const auto hint = [](const Edit& edit) { return test::error_of([&] { edited({edit}); }).hint; };
  EXPECT_EQ(hint(RemoveFeature{"rip"}), "did you mean `rib`?");
  EXPECT_EQ(hint(SetParameter{"W", 1.0}), "did you mean `w`?");
  EXPECT_EQ(hint(SetFeatureParameter{"rib", "hight", Scalar(1.0)}), "did you mean `height`?");
  EXPECT_EQ(hint(RemoveFeature{"flange"}), "ids are case-sensitive");
  EXPECT_EQ(test::error_of([] {
              edited({SetGroup{"load", "rib", {}}, RemoveGroup{"lead"}});
            }).hint,
            "did you mean `load`?");
}

TEST(Apply, UnknownFeaturesAreNotFound) {
  const ErrorInfo info = test::error_of([] { edited({RemoveFeature{"nut"}}); });
  EXPECT_EQ(info.kind, ErrorKind::NotFound);
}

TEST(Apply, FeaturesThatExistOrHaveABadNameCannotBeAdded) {
  FeatureSource f = test::feature("rib", "sphere", {{"radius", 1.0}});
  EXPECT_EQ(edit_failure(AddFeature{f, ""}), "1 DUPLICATE_FEATURE rib -");
  f.id = "rib 2";
  EXPECT_EQ(edit_failure(AddFeature{f, ""}), "1 INVALID_NAME rib 2 id");
}

TEST(Apply, AProfileIsNoNumberAndANumberNoProfile) {
  EXPECT_EQ(edit_failure(SetFeatureParameter{"rib", "profile", Scalar(3.0)}),
            "1 WRONG_VALUE_KIND rib profile");
  EXPECT_EQ(edit_failure(SetFeatureParameter{"rib", "height", kTriangle}),
            "1 WRONG_VALUE_KIND rib height");
}

TEST(Apply, AFeatureOfUnknownTypeHasNoParametersToSet) {
  EXPECT_EQ(edit_failure(AddFeature{test::feature("blob", "blob"), "nowhere"}),
            "1 UNKNOWN_FEATURE nowhere -");
  const ErrorInfo info = test::error_of([] {
    edited({AddFeature{test::feature("blob", "blob"), ""},
            SetFeatureParameter{"blob", "size", Scalar(1.0)}});
  });
  EXPECT_EQ(test::place_of(info), "UNKNOWN_FEATURE_TYPE blob type");
  EXPECT_EQ(info.edit_index, 1);
}

TEST(Apply, SetSizeAddsAControlAtTheEnd) {
  const ModelSource model =
      edited({SetSize{"a", "base.top", 2.0}, SetSize{"b", BallSource{0.0, 0.0, 0.0, 1.0}, "w/9"}});
  ASSERT_EQ(model.sizes.size(), 2U);
  EXPECT_EQ(model.sizes[0], (SizeControlSource{"a", "base.top", 2.0}));
  EXPECT_EQ(model.sizes[1], (SizeControlSource{"b", BallSource{0.0, 0.0, 0.0, 1.0}, "w/9"}));
}

TEST(Apply, SetSizeOfOneThatIsThereKeepsWhatItLeavesOut) {
  const SetSize a{"a", "base.top", 2.0}, b{"b", "rib", 3.0};
  EXPECT_EQ(edited({a, b, SetSize{"a", {}, Scalar("w")}}).sizes,
            (std::vector<SizeControlSource>{{"a", "base.top", "w"}, {"b", "rib", 3.0}}));
  EXPECT_EQ(edited({a, b, SetSize{"a", "base", {}}}).sizes,
            (std::vector<SizeControlSource>{{"a", "base", 2.0}, {"b", "rib", 3.0}}));
}

TEST(Apply, RemoveSizeTakesOneOut) {
  EXPECT_EQ(edited({SetSize{"a", "base", 2.0}, SetSize{"b", "rib", 3.0}, RemoveSize{"a"}}).sizes,
            (std::vector<SizeControlSource>{{"b", "rib", 3.0}}));
}

TEST(Apply, SetGroupAddsAGroupOrChangesTheOneOfThatName) {
  const SetGroup a{"a", "base.top", {}}, b{"b", "rib", GroupPolicy{.fail_emptied = true}};
  EXPECT_EQ(edited({a, b}).groups,
            (std::vector<GroupSource>{{"a", "base.top", {}}, {"b", "rib", {{}, true}}}));
  EXPECT_EQ(edited({a, b, SetGroup{"b", "rib.top", {}}}).groups[1],
            (GroupSource{"b", "rib.top", {{}, true}}));
  EXPECT_EQ(edited({a, b, SetGroup{"b", {}, GroupPolicy{.max_area_change = 0.5}}}).groups[1],
            (GroupSource{"b", "rib", {0.5, false}}))
      << "a policy replaces the whole policy";
}

TEST(Apply, RemoveGroupTakesOneOut) {
  EXPECT_EQ(edited({SetGroup{"a", "base", {}}, SetGroup{"b", "rib", {}}, RemoveGroup{"a"}}).groups,
            (std::vector<GroupSource>{{"b", "rib", {}}}));
}

TEST(Apply, TellsWhatIsWrongWithAnEditOfAGroup) {
  EXPECT_EQ(edit_failure(SetGroup{"a", {}, GroupPolicy{}}), "1 MISSING_FIELD - groups.a.on");
  EXPECT_EQ(edit_failure(RemoveGroup{"a"}), "1 UNKNOWN_GROUP - groups.a");
}

TEST(Apply, TellsWhatIsWrongWithAnEditOfASize) {
  EXPECT_EQ(edit_failure(SetSize{"a", "base", {}}), "1 MISSING_FIELD - sizes.a.size");
  EXPECT_EQ(edit_failure(SetSize{"a", {}, 1.0}), "1 MISSING_FIELD - sizes.a.on");
  EXPECT_EQ(edit_failure(RemoveSize{"a"}), "1 UNKNOWN_SIZE - sizes.a");
}

}  // namespace
}  // namespace remeshd
