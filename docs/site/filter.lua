-- What pandoc's reader leaves to do: links and pictures lead into the site, equations get numbers, pictures captions.
-- Metadata from build_site.py: `folder` is where the page stands in the repository ("docs"), `root` the repository, `pages` a file that returns a
-- table, each page's source to its file in the site.
local stringify = pandoc.utils.stringify
local folder, root, files, equations = '', '', {}, {}

-- "docs", "../lighting/fog.hpp" -> "lighting/fog.hpp"
local function from_root(target)
  local parts = {}
  for part in (folder .. '/' .. target):gmatch('[^/]+') do
    if part == '..' then table.remove(parts) elseif part ~= '.' then table.insert(parts, part) end
  end
  return table.concat(parts, '/')
end

local function escaped(text)
  return (text:gsub('[&<>"]', { ['&'] = '&amp;', ['<'] = '&lt;', ['>'] = '&gt;', ['"'] = '&quot;' }))
end

local function Meta(meta)
  folder = meta.folder and stringify(meta.folder) or ''
  root = stringify(meta.root)
  files = dofile(stringify(meta.pages))
end

local function Link(link)
  for i, inline in ipairs(link.content) do
    if inline.t == 'Link' then link.content[i] = inline.content[1] end  -- made by Code below: no link in a link
  end
  local target, mark = link.target:match('^([^#]*)(#?.*)$')
  if target == '' or target:match('^%a+:') then return nil end
  local path = from_root(target)
  if path:match('%.png$') then
    link.target = 'pictures/' .. path:gsub('^docs/images/', 'docs/')
  elseif path == 'docs/references.bib' then
    link.target = 'references.html' .. (mark ~= '' and '#ref-' .. mark:sub(2) or '')
    link.classes:insert('cite')
  elseif files[path] then
    link.target = files[path] .. mark
  else
    link.target = 'source/' .. path:gsub('/', '--') .. '.html' .. mark
  end
  return link
end

-- `lighting/fog.hpp` leads to the file, where there is one.
local function Code(code)
  if not code.text:match('^%l[%w_/]*/[%w_]+%.[ch]pp$') then return nil end
  local file = io.open(root .. '/' .. code.text)
  if not file then return nil end
  file:close()
  return pandoc.Link(code, 'source/' .. code.text:gsub('/', '--') .. '.html')
end

local function Image(image)
  if image.src:match('^%a+:') then return nil end
  image.src = 'pictures/' .. from_root(image.src):gsub('^docs/images/', 'docs/')
  image.attributes.loading = 'lazy'
  return image
end

-- A picture alone in its paragraph is a figure; its words are the caption.
local function figure(image)
  local caption = pandoc.write(pandoc.Pandoc({ pandoc.Plain(image.caption) }), 'html')
  local html = ('<figure><a href="%s"><img src="%s" alt="%s"></a><figcaption>%s</figcaption></figure>')
  return pandoc.RawBlock('html', html:format(escaped(image.src), escaped(image.src), escaped(stringify(image.caption)), caption))
end

local function display(math)
  local number = math.text:match('\\tag{([^}]*)}')
  math.text = math.text:gsub('%s*\\tag{[^}]*}', '')
  if not number then return { pandoc.Div({ pandoc.Plain({ math }) }, { class = 'equation' }) } end
  local link = pandoc.Link('(' .. number .. ')', '#eq-' .. number, '', { class = 'number' })
  return { pandoc.Div({ pandoc.Plain({ math, link }) }, { id = 'eq-' .. number, class = 'equation numbered' }) }
end

local indexed  -- below

local function is_space(inline) return inline.t == 'Space' or inline.t == 'SoftBreak' end

-- A paragraph is split where equations stand in it.
local function Para(para)
  if #para.content == 1 and para.content[1].t == 'Image' then return figure(para.content[1]) end
  local blocks, words = {}, pandoc.List()
  local function end_words()
    while #words > 0 and is_space(words[1]) do words:remove(1) end
    if #words > 0 then table.insert(blocks, pandoc.Para(words)) end
    words = pandoc.List()
  end
  for _, inline in ipairs(para.content) do
    if inline.t == 'Math' and inline.mathtype == 'DisplayMath' then
      end_words()
      for _, block in ipairs(display(inline)) do table.insert(blocks, block) end
    else
      words:insert(inline)
    end
  end
  if #blocks == 0 then return nil end
  end_words()
  return blocks
end

local function find_equations(math)
  local number = math.text:match('\\tag{([^}]*)}')
  if number then equations[number] = true end
end

local mentioned = {}  -- the N of every "(N)"
local function find_mention(str)
  local number = str.text:match('%((%d+)%)')
  if number then mentioned[number] = true end
end

-- Statements share their numbers with the equations: a list of The idea that does not begin with 1,
-- or whose (1) is no equation although (1) is mentioned or other equations have numbers.
local function holds_statements(block)
  if block.t ~= 'OrderedList' then return false end
  return block.start > 1 or not equations['1'] and (mentioned['1'] or next(equations)) ~= nil
end

local function statement(blocks, number)
  local link = pandoc.RawBlock('html', ('<a class="number" href="#eq-%s">(%s)</a>'):format(number, number))
  return pandoc.Div({ pandoc.Div(blocks), link }, { id = 'eq-' .. number, class = 'statement' })
end

local function number_statements(doc)
  local blocks, within, found = pandoc.List(), false, {}
  for _, block in ipairs(doc.blocks) do
    if block.t == 'Header' and block.level == 2 then within = stringify(block) == 'The idea' end
    if within and holds_statements(block) then
      for i, item in ipairs(block.content) do
        local number = tostring(block.start + i - 1)
        found[number] = true
        blocks:insert(statement(item, number))
      end
    else
      blocks:insert(block)
    end
  end
  for number in pairs(found) do equations[number] = true end
  doc.blocks = blocks
  return doc
end

-- "(3)" is a link to equation or statement (3), where the page has one.
local function Str(str)
  local before, number, after = str.text:match('^(%p-)%((%d+)%)(%p*)$')
  if not number or not equations[number] then return indexed(str.text) end
  return { pandoc.Str(before), pandoc.Link('(' .. number .. ')', '#eq-' .. number), pandoc.Str(after) }
end

local function formula(latex) return pandoc.Math('InlineMath', latex) end

-- **n** is a vector: a formula, as in the equations.
local function Strong(strong)
  local word = #strong.content == 1 and strong.content[1].t == 'Str' and strong.content[1].text
  if not word then return nil end
  local letter, prime = word:match("^(%a)([\xe2\x80\xb2]*)$")
  if not letter then return nil end
  return formula('\\mathbf{' .. letter .. '}' .. (prime ~= '' and "'" or ''))
end

local function subscript(index) return #index <= 2 and index or '\\mathrm{' .. index .. '}' end

-- k_d, F_0, w_clip: a letter with its index, as the equations have it.
function indexed(text)
  local before, letter, index, after = text:match('^([%(|√]*)(%a)_(%w+)(.*)$')
  if not letter then before, letter, index, after = text:match('^([%(|√]*)([\xce\xcf][\x80-\xbf])_(%w+)(.*)$') end
  if not letter or after:match('^_') then return nil end
  local shown = subscript(index)
  return { pandoc.Str(before), formula(letter .. '_{' .. shown .. '}'), pandoc.Str(after) }
end

-- Marks for tests, <!-- number: ... -->, go with the space before them.
local function Inlines(inlines)
  local kept = pandoc.List()
  for _, inline in ipairs(inlines) do
    if inline.t == 'RawInline' and inline.text:match('^<!%-%-') then
      if #kept > 0 and kept[#kept].t == 'Space' then kept:remove() end
    else
      local index, after
      if inline.t == 'Str' then index, after = inline.text:match('^_(%w+)(.*)$') end
      if index and #kept > 0 and kept[#kept].t == 'Strong' then  -- **l**_k
        local letter = stringify(kept:remove())
        kept:insert(formula('\\mathbf{' .. letter .. '}_{' .. subscript(index) .. '}'))
        kept:insert(pandoc.Str(after))
      else
        kept:insert(inline)
      end
    end
  end
  return kept
end

-- A table of two pictures is a pair: side by side, or one under a handle where scripts run.
local function pair(tbl)
  local simple = pandoc.utils.to_simple_table(tbl)
  if #simple.rows ~= 1 or #simple.rows[1] ~= 2 then return nil end
  local figures = ''
  for _, cell in ipairs(simple.rows[1]) do
    local image = #cell == 1 and cell[1].content and #cell[1].content == 1 and cell[1].content[1]
    if not image or image.t ~= 'Image' then return nil end
    figures = figures .. ('<figure><img src="%s" alt="%s"><figcaption>%s</figcaption></figure>'):format(
      escaped(image.src), escaped(stringify(image.caption)), escaped(stringify(image.caption)))
  end
  return pandoc.RawBlock('html', '<div class="pair">' .. figures .. '</div>')
end

-- Wide tables scroll by themselves, the page does not; a key board reaches them.
local tables = 0
local function Table(tbl)
  local two = pair(tbl)
  if two then return two end
  tables = tables + 1
  local open = '<div class="wide" tabindex="0" role="region" aria-label="table %d">'
  return { pandoc.RawBlock('html', open:format(tables)), tbl,
           pandoc.RawBlock('html', '</div>') }
end

local function Header(header)
  if header.level == 1 then return {} end
end

return { { Meta = Meta }, { Math = find_equations, Str = find_mention }, { Pandoc = number_statements },
         { Inlines = Inlines, Strong = Strong, Code = Code, Link = Link, Image = Image, Str = Str, Header = Header },
         { Para = Para, Table = Table } }
