#include "core/window/ui_style.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "core/image/theme.h"

namespace seesaw {

UiColors ui_colors(bool dark) {
  if (dark)
    return {hex("#14181D"), hex("#1D2329"), hex("#39424C"), hex("#2A323A"),
            hex("#E8ECF0"), hex("#9AA5B1"), hex("#4BA3DB"), hex("#FF7A5C")};
  return {theme::paper, hex("#F6F7F9"),  theme::grid,      hex("#E6EAEE"),
          theme::ink,   theme::soft_ink, theme::series[0], theme::moved};
}

namespace detail {

namespace {

ImVec4 vec(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a)};
}

void set_colors(const UiColors& c) {
  ImVec4* to = ImGui::GetStyle().Colors;
  const ImVec4 clear(0, 0, 0, 0), field = vec(c.field), hovered = vec(mix(c.field, c.accent, 0.25)),
                                  active = vec(mix(c.field, c.accent, 0.5)), accent = vec(c.accent);
  for (const auto& [index, color] : std::initializer_list<std::pair<ImGuiCol, ImVec4>>{
           {ImGuiCol_Text, vec(c.ink)},
           {ImGuiCol_TextDisabled, vec(c.soft_ink)},
           {ImGuiCol_WindowBg, vec(c.panel)},
           {ImGuiCol_ChildBg, clear},
           {ImGuiCol_PopupBg, vec(c.panel)},
           {ImGuiCol_Border, vec(c.line)},
           {ImGuiCol_BorderShadow, clear},
           {ImGuiCol_FrameBg, field},
           {ImGuiCol_FrameBgHovered, hovered},
           {ImGuiCol_FrameBgActive, active},
           {ImGuiCol_TitleBg, vec(c.field)},
           {ImGuiCol_TitleBgActive, vec(c.field)},
           {ImGuiCol_TitleBgCollapsed, vec(c.field)},
           {ImGuiCol_MenuBarBg, vec(c.panel)},
           {ImGuiCol_ScrollbarBg, clear},
           {ImGuiCol_ScrollbarGrab, vec(mix(c.panel, c.soft_ink, 0.35))},
           {ImGuiCol_ScrollbarGrabHovered, vec(mix(c.panel, c.soft_ink, 0.6))},
           {ImGuiCol_ScrollbarGrabActive, vec(c.soft_ink)},
           {ImGuiCol_CheckMark, accent},
           {ImGuiCol_SliderGrab, vec(mix(c.field, c.accent, 0.4))},
           {ImGuiCol_SliderGrabActive, vec(mix(c.field, c.accent, 0.55))},
           {ImGuiCol_Button, field},
           {ImGuiCol_ButtonHovered, hovered},
           {ImGuiCol_ButtonActive, active},
           {ImGuiCol_Header, hovered},
           {ImGuiCol_HeaderHovered, vec(mix(c.panel, c.accent, 0.2))},
           {ImGuiCol_HeaderActive, active},
           {ImGuiCol_Separator, vec(c.line)},
           {ImGuiCol_SeparatorHovered, accent},
           {ImGuiCol_SeparatorActive, accent},
           {ImGuiCol_ResizeGrip, clear},
           {ImGuiCol_ResizeGripHovered, hovered},
           {ImGuiCol_ResizeGripActive, active},
           {ImGuiCol_Tab, vec(c.panel)},
           {ImGuiCol_TabHovered, hovered},
           {ImGuiCol_TabActive, vec(mix(c.panel, c.accent, 0.3))},
           {ImGuiCol_TabUnfocused, vec(c.panel)},
           {ImGuiCol_TabUnfocusedActive, vec(mix(c.panel, c.accent, 0.3))},
           {ImGuiCol_PlotHistogram, accent},
           {ImGuiCol_TableHeaderBg, field},
           {ImGuiCol_TableBorderStrong, vec(c.line)},
           {ImGuiCol_TableBorderLight, vec(c.line)},
           {ImGuiCol_TableRowBg, clear},
           {ImGuiCol_TableRowBgAlt, vec(c.ink.with_alpha(0.03))},
           {ImGuiCol_TextSelectedBg, vec(c.accent.with_alpha(0.35))},
           {ImGuiCol_DragDropTarget, accent},
           {ImGuiCol_NavHighlight, accent},
           {ImGuiCol_ModalWindowDimBg, vec(theme::ink.with_alpha(0.35))},
       })
    to[index] = color;
}

/// Where Debian, Fedora, Arch and macOS keep the font; empty where none of them has it.
std::string font_file(const std::string& name) {
  for (const char* folder :
       {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts", "/usr/share/fonts/TTF",
        "/usr/share/fonts/dejavu", "/usr/local/share/fonts", "/Library/Fonts", "/opt/homebrew/share/fonts"}) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) return path.string();
  }
  return {};
}

// Pairs of first and last letter; the list must live as long as the fonts.
constexpr ImWchar letters[] = {0x20,   0x17F,  0x2C6,  0x2DC,  0x370,  0x3FF,  0x2010, 0x2027,
                               0x2030, 0x203A, 0x2070, 0x209C, 0x20AC, 0x20AC, 0x2102, 0x2124,
                               0x2190, 0x21FF, 0x2200, 0x22FF, 0x2308, 0x230B, 0x25A0, 0x25FF,
                               0x2600, 0x2606, 0x2713, 0x2717, 0xFFFD, 0xFFFD, 0};
constexpr ImWchar plain_letters[] = {0x20, 0x17F, 0x370, 0x3FF, 0x2010, 0x2027, 0x2190, 0x2193, 0};

}  // namespace

void set_style(bool dark, double scale) {
  ImGuiStyle style;
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 3};
  style.WindowRounding = 0;
  style.ChildRounding = 4;
  style.PopupRounding = 4;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 13;
  style.GrabMinSize = 12;
  style.IndentSpacing = 16;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0, 0.5f};
  style.ScaleAllSizes(static_cast<float>(scale));
  style.CircleTessellationMaxError = 0.15f;
  ImGui::GetStyle() = style;
  set_colors(ui_colors(dark));
}

UiFonts build_fonts(double scale, double pixel_ratio) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  ImGui::GetIO().FontGlobalScale = static_cast<float>(1 / pixel_ratio);
  // Whole pixels: letters of fractional size are placed and filtered badly.
  const auto size_of = [&](double relative) {
    return static_cast<float>(std::max(6.0, std::round(relative * text_size * scale * pixel_ratio)));
  };
  const std::string regular = font_file("DejaVuSans.ttf"), bold = font_file("DejaVuSans-Bold.ttf");
  UiFonts fonts;
  const auto load = [&](const std::string& file, double relative, const ImWchar* ranges) {
    ImFontConfig config;
    config.SizePixels = size_of(relative);
    // Large letters are smooth without, and their atlas stays small.
    config.OversampleH = config.SizePixels > 26 ? 1 : 2;
    config.OversampleV = 1;
    ImFont* font =
        file.empty() ? nullptr : atlas.AddFontFromFileTTF(file.c_str(), config.SizePixels, &config, ranges);
    return font ? font : atlas.AddFontDefault(&config);
  };
  fonts.regular = load(regular, 1, letters);
  fonts.bold = load(bold, 1, plain_letters);
  fonts.heading = load(bold, 1.3, plain_letters);
  return fonts;
}

}  // namespace detail
}  // namespace seesaw
